// What C++ wrote (app/report/html_report.cpp), unpacked:
//
// view:       {azimuth_deg, elevation_deg}: where the viewer stands at first
// unit:       what positions are stored in; a power of two, 1 for all but extreme sizes
// points:     {positions: Float32Array x,y,z relative to `origin`, parts: [{name, first, count}],
//              texts, labels: Uint32Array, fields: [{name, unit, values: Float32Array}]}
// geometries: [{id, name, kind: triangles | lines | points, indices: Uint32Array, texts, labels}]
// layers:     [{id, name, geometry, color, labels, field, opacity}]
// stages:     [{name, caption, layers: ids}]
// tables:     [{title, columns, bars, rows: [{cells}]}]

function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

function floatsOf(text) {
  return new Float32Array(bytesOfBase64(text).buffer);
}

// Groups of seven bits, of differences whose sign is in the lowest bit.
export function integersOf(text) {
  const bytes = bytesOfBase64(text);
  let count = 0;
  for (const byte of bytes) if (byte < 128) ++count;
  const numbers = new Uint32Array(count);
  let last = 0, at = 0;
  for (let n = 0; n < count; ++n) {
    let code = 0, shift = 0, byte;
    do {
      byte = bytes[at++];
      code |= (byte & 127) << shift;
      shift += 7;
    } while (byte >= 128);
    last = (last + ((code >>> 1) ^ -(code & 1))) >>> 0;
    numbers[n] = last;
  }
  return numbers;
}

export const cornersOf = {triangles: 3, lines: 2, points: 1};

export function readReport() {
  const report = JSON.parse(document.getElementById("report").textContent);
  const {points} = report;
  points.positions = floatsOf(points.positions);
  points.labels = integersOf(points.labels);
  for (const field of points.fields) field.values = floatsOf(field.values);
  for (const geometry of report.geometries) {
    geometry.indices = integersOf(geometry.indices);
    geometry.labels = integersOf(geometry.labels);
    geometry.corners = cornersOf[geometry.kind];
  }
  return report;
}

// The ids of a layer's elements in its geometry, ascending.
export function elementsOf(layer, geometry) {
  const count = geometry.indices.length / geometry.corners;
  const wanted = new Set(layer.labels);
  const elements = new Uint32Array(count);
  let n = 0;
  for (let e = 0; e < count; ++e) {
    if (wanted.size === 0 || wanted.has(geometry.labels[e])) elements[n++] = e;
  }
  return elements.slice(0, n);
}
