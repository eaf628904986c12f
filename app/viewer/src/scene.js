// The layers of the report as objects of three.js. All share one array of positions.
import {
  Box3, BufferAttribute, BufferGeometry, Color, DirectionalLight, Group, HemisphereLight, LineBasicMaterial,
  LineSegments, Mesh, MeshLambertMaterial, Points, Scene, ShaderMaterial, DoubleSide,
} from "three";
import {LineMaterial} from "three/examples/jsm/lines/LineMaterial.js";
import {LineSegments2} from "three/examples/jsm/lines/LineSegments2.js";
import {LineSegmentsGeometry} from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import {elementsOf} from "./data.js";

// Below 0, 0, above 0.
export const fieldColors = ["#2166ac", "#f1efe9", "#b2182b"];

// Points are small disks, shaded by the normal of the surface through them, and a little nearer
// than they are: else those on a surface would flicker.
function pointMaterial(color) {
  return new ShaderMaterial({
    uniforms: {color: {value: new Color(color)}, size: {value: 3}},
    vertexShader: `
      uniform float size;
      varying float light;
      void main() {
        vec3 n = normalize(normalMatrix * normal);
        light = dot(normal, normal) < 0.5 ? 0.9 : 0.5 + 0.5 * abs(n.z);
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
        gl_Position.z -= 2e-4 * gl_Position.w;
        gl_PointSize = size;
      }`,
    fragmentShader: `
      uniform vec3 color;
      varying float light;
      void main() {
        if (length(gl_PointCoord - 0.5) > 0.5) discard;
        gl_FragColor = vec4(color * light, 1.0);
        #include <colorspace_fragment>
      }`,
  });
}

// Sums of facet normals at the points of all triangles; later geometries win where several share a
// point, as the updated model is the last one.
function pointNormals(report) {
  const {positions: p} = report.points;
  const normals = new Float32Array(p.length);
  for (const {kind, indices} of report.geometries) {
    if (kind !== "triangles") continue;
    for (const i of indices) normals.fill(0, 3 * i, 3 * i + 3);
    for (let t = 0; t < indices.length; t += 3) {
      const a = 3 * indices[t], b = 3 * indices[t + 1], c = 3 * indices[t + 2];
      const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
      const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
      for (const at of [a, b, c]) {
        normals[at] += x;
        normals[at + 1] += y;
        normals[at + 2] += z;
      }
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let k = 0; k < 3; ++k) normals[i + k] /= length;
  }
  return normals;
}

// Each undirected side of the triangles once, as pairs of indices.
function sidesOf(triangles) {
  const keys = new Float64Array(triangles.length);
  for (let t = 0; t < triangles.length; t += 3) {
    for (let i = 0; i < 3; ++i) {
      const a = triangles[t + i], b = triangles[t + (i + 1) % 3];
      keys[t + i] = Math.min(a, b) * 4294967296 + Math.max(a, b);
    }
  }
  keys.sort();
  const sides = new Uint32Array(2 * keys.length);
  let n = 0;
  for (let i = 0; i < keys.length; ++i) {
    if (i > 0 && keys[i] === keys[i - 1]) continue;
    sides[n++] = Math.floor(keys[i] / 4294967296);
    sides[n++] = keys[i] % 4294967296;
  }
  return sides.slice(0, n);
}

export class ReportScene {
  constructor(report) {
    this.report = report;
    this.positions = new BufferAttribute(report.points.positions, 3);
    this.normals = new BufferAttribute(pointNormals(report), 3);
    this.box = new Box3().setFromBufferAttribute(this.positions);
    if (this.box.isEmpty()) this.box.setFromArray([-1, -1, -1, 1, 1, 1]);
    this.scene = new Scene();
    this.lights = new Group();
    const key = new DirectionalLight("#ffffff", 2.1), fill = new DirectionalLight("#ffffff", 0.5);
    key.position.set(-0.35, 0.55, 1);
    fill.position.set(0.8, -0.4, 0.6);
    this.lights.add(key, fill);
    const sky = new HemisphereLight("#ffffff", "#8c8378", 1.25);
    sky.position.set(0, 0, 1);
    this.scene.add(sky, this.lights);

    const geometryOf = new Map(report.geometries.map(geometry => [geometry.id, geometry]));
    this.layers = report.layers.map((layer, order) => {
      const geometry = geometryOf.get(layer.geometry);
      const elements = elementsOf(layer, geometry);
      const made = {...layer, geometry, elements, order};
      made.indices = this.indicesOf(made);
      made.object = this.objectOf(made);
      made.object.renderOrder = order;
      made.object.frustumCulled = false;
      this.scene.add(made.object);
      return made;
    });
  }

  indicesOf({geometry, elements}) {
    if (elements.length * geometry.corners === geometry.indices.length) return geometry.indices;
    const {corners} = geometry, indices = new Uint32Array(corners * elements.length);
    elements.forEach((e, n) => {
      for (let k = 0; k < corners; ++k) indices[corners * n + k] = geometry.indices[corners * e + k];
    });
    return indices;
  }

  bufferOf(indices) {
    const buffer = new BufferGeometry();
    buffer.setAttribute("position", this.positions);
    buffer.setAttribute("normal", this.normals);
    buffer.setIndex(new BufferAttribute(indices, 1));
    return buffer;
  }

  objectOf(layer) {
    if (layer.geometry.kind === "points") return new Points(this.bufferOf(layer.indices), pointMaterial(layer.color));
    if (layer.geometry.kind === "lines") return this.linesOf(layer);
    const buffer = this.bufferOf(layer.indices);
    const material = new MeshLambertMaterial({
      color: layer.color, flatShading: true, side: DoubleSide,
      transparent: layer.opacity < 1, opacity: layer.opacity, depthWrite: layer.opacity >= 1,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    });
    const field = this.report.points.fields.find(({name}) => name === layer.field);
    if (field) {
      const most = field.values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
      layer.scale = field.unit * most;
      buffer.setAttribute("color", new BufferAttribute(colorsOf(field.values, most), 3));
      material.color.set("#ffffff");
      material.vertexColors = true;
    }
    return new Mesh(buffer, material);
  }

  linesOf(layer) {
    const {positions} = this.report.points;
    const ends = new Float32Array(3 * layer.indices.length);
    layer.indices.forEach((index, n) => {
      for (let k = 0; k < 3; ++k) ends[3 * n + k] = positions[3 * index + k];
    });
    const geometry = new LineSegmentsGeometry().setPositions(ends);
    return new LineSegments2(geometry, new LineMaterial({
      color: layer.color, linewidth: 2.6, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -1500,
    }));
  }

  // Only the given layers are seen from now on.
  show(visible, {edges, pointSize}) {
    for (const layer of this.layers) {
      layer.object.visible = visible.has(layer.id);
      if (layer.geometry.kind === "points") layer.object.material.uniforms.size.value = pointSize;
      if (layer.geometry.kind !== "triangles") continue;
      if (edges && layer.object.visible && !layer.edges) {
        layer.edges = new LineSegments(this.bufferOf(sidesOf(layer.indices)), new LineBasicMaterial({
          color: "#1b2530", transparent: true, opacity: 0.4}));
        layer.edges.frustumCulled = false;
        layer.edges.renderOrder = this.layers.length + layer.order;
        layer.object.add(layer.edges);
      }
      if (layer.edges) layer.edges.visible = edges;
    }
  }
}

function colorsOf(values, scale) {
  const [low, middle, high] = fieldColors.map(color => new Color(color));
  const colors = new Float32Array(3 * values.length), color = new Color();
  values.forEach((value, i) => {
    const share = scale > 0 ? value / scale : 0;
    color.copy(middle).lerp(share < 0 ? low : high, Math.sqrt(Math.abs(share)) * 0.35 + Math.abs(share) * 0.65);
    color.toArray(colors, 3 * i);
  });
  return colors;
}
