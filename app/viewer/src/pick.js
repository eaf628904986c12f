// What lies under a place of a pane: plain loops over the visible layers, some milliseconds for
// 200,000 triangles, so that nothing has to be kept ready for it.
import {Vector3} from "three";

// The triangle that the ray meets first (Moeller & Trumbore 1997).
function firstTriangle(ray, positions, layers) {
  const {origin: o, direction: d} = ray;
  let best = null, nearest = Infinity;
  for (const layer of layers) {
    if (layer.geometry.kind !== "triangles") continue;
    const {indices} = layer;
    for (let t = 0; t < indices.length; t += 3) {
      const a = 3 * indices[t], b = 3 * indices[t + 1], c = 3 * indices[t + 2];
      const ax = positions[a], ay = positions[a + 1], az = positions[a + 2];
      const ux = positions[b] - ax, uy = positions[b + 1] - ay, uz = positions[b + 2] - az;
      const vx = positions[c] - ax, vy = positions[c + 1] - ay, vz = positions[c + 2] - az;
      const px = d.y * vz - d.z * vy, py = d.z * vx - d.x * vz, pz = d.x * vy - d.y * vx;
      const determinant = ux * px + uy * py + uz * pz;
      if (determinant === 0) continue;
      const wx = o.x - ax, wy = o.y - ay, wz = o.z - az;
      const s = (wx * px + wy * py + wz * pz) / determinant;
      if (s < 0 || s > 1) continue;
      const qx = wy * uz - wz * uy, qy = wz * ux - wx * uz, qz = wx * uy - wy * ux;
      const r = (d.x * qx + d.y * qy + d.z * qz) / determinant;
      if (r < 0 || s + r > 1) continue;
      const along = (vx * qx + vy * qy + vz * qz) / determinant;
      // Of layers that show the same triangle the last one is seen.
      if (along > 0 && along <= nearest) {
        nearest = along;
        best = {layer, element: layer.elements[t / 3], place: t / 3, along};
      }
    }
  }
  return best;
}

// The point or end of a line nearest to the middle of the pointer, if within `reach` pixels and not
// behind `limit` (a distance from the eye).
function nearestPoint(camera, pointer, height, positions, layers, reach, limit) {
  const p = new Vector3(), eye = camera.position;
  let best = null, nearest = reach;
  for (const layer of layers) {
    if (layer.geometry.kind === "triangles") continue;
    const {corners} = layer.geometry;
    layer.indices.forEach((index, n) => {
      p.fromArray(positions, 3 * index);
      if (p.distanceTo(eye) > limit) return;
      p.project(camera);
      const away = Math.hypot((p.x - pointer.x) * camera.aspect, p.y - pointer.y) * height / 2;
      if (away < nearest) {
        nearest = away;
        best = {layer, element: layer.elements[Math.floor(n / corners)], place: Math.floor(n / corners), index};
      }
    });
  }
  return best;
}

// pointer: in [-1, 1]^2 of the pane, y upward; height: of the pane in pixels.
// Result: {layer, element, vertex: index of the point nearest to the place}, or null.
export function pick(camera, pointer, height, positions, layers, size) {
  const direction = new Vector3(pointer.x, pointer.y, 0.5).unproject(camera).sub(camera.position).normalize();
  const triangle = firstTriangle({origin: camera.position, direction}, positions, layers);
  const limit = triangle ? triangle.along + 0.004 * size : Infinity;
  const point = nearestPoint(camera, pointer, height, positions, layers, 7, limit);
  if (point) return {layer: point.layer, element: point.element, place: point.place, vertex: point.index};
  if (!triangle) return null;
  const place = camera.position.clone().addScaledVector(direction, triangle.along), corner = new Vector3();
  const corners = [0, 1, 2].map(k => triangle.layer.indices[3 * triangle.place + k]);
  const away = corners.map(index => corner.fromArray(positions, 3 * index).distanceTo(place));
  const vertex = corners[away.indexOf(Math.min(...away))];
  return {layer: triangle.layer, element: triangle.element, place: triangle.place, vertex};
}
