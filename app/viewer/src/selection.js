// What was picked: said in words, and marked in the panes.
import {
  BufferAttribute, BufferGeometry, DoubleSide, Group, Line, LineBasicMaterial, Mesh, MeshBasicMaterial, Points,
  PointsMaterial,
} from "three";
import {element, numberText} from "./tables.js";

const nouns = {triangles: "facet", lines: "edge", points: "point"};

function partOf(report, index) {
  return report.points.parts.find(({first, count}) => index >= first && index < first + count);
}

// The lines of text that describe {layer, element, vertex}: [name, value] each.
export function describe(report, {layer, element: id, vertex}) {
  const {geometry} = layer, lines = [];
  const text = geometry.texts[geometry.labels[id]];
  if (geometry.kind !== "points") {
    lines.push([nouns[geometry.kind], `${id.toLocaleString("en-US")} of ${geometry.name}`]);
    if (text) lines.push(["", text]);
  }
  const part = partOf(report, vertex);
  lines.push([part.name === "initial model" ? "vertex" : "point",
              `${(vertex - part.first).toLocaleString("en-US")} of ${part.name}`]);
  const label = report.points.texts[report.points.labels[vertex]];
  if (label) lines.push(["", label]);
  const place = [0, 1, 2].map(k => report.unit * report.points.positions[3 * vertex + k] + report.origin[k]);
  lines.push(["at", place.map(x => numberText(x, 6)).join(", ")]);
  for (const field of report.points.fields) lines.push([field.name, numberText(field.unit * field.values[vertex])]);
  return lines;
}

export function selectionCard(report, picked) {
  const list = element("dl");
  for (const [name, value] of describe(report, picked)) list.append(element("dt", name), element("dd", value));
  return list;
}

// The facet or edge and the vertex, in front of everything but what hides them.
export function selectionMark(report, {layer, place, vertex}) {
  const at = index => report.points.positions.subarray(3 * index, 3 * index + 3);
  const shape = (indices) => {
    const corners = new Float32Array(3 * indices.length);
    indices.forEach((index, n) => corners.set(at(index), 3 * n));
    return new BufferGeometry().setAttribute("position", new BufferAttribute(corners, 3));
  };
  const mark = new Group(), {corners} = layer.geometry;
  const indices = [...layer.indices.subarray(corners * place, corners * place + corners)];
  if (corners === 3) {
    mark.add(new Mesh(shape(indices), new MeshBasicMaterial({
      color: "#fff04d", side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -20})));
  }
  if (corners > 1) {
    mark.add(new Line(shape([...indices, indices[0]]), new LineBasicMaterial({color: "#101820", depthTest: false})));
  }
  const dot = (size, color) => new Points(shape([vertex]), new PointsMaterial({
    size, color, sizeAttenuation: false, depthTest: false}));
  mark.add(dot(11, "#101820"), dot(7, "#fff04d"));
  mark.children.forEach((child, order) => {
    child.renderOrder = 1000 + order;
    child.frustumCulled = false;
    child.material.transparent = true;  // drawn last
  });
  return mark;
}
