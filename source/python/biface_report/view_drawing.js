// SPDX-License-Identifier: LGPL-2.1-or-later
/* What a view is drawn with: the shader of the shell, lines, rigid bodies. */
"use strict";

const VERTEX = `
  attribute float value;
  varying float v;
  varying vec3 n;
  void main() {
    v = value;
    n = normalMatrix * normal;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;
// only gray areas are lit, and all with the shading on: colors are those of values
const FRAGMENT = `
  uniform sampler2D colors;
  uniform float low, high, gray, shading;
  varying float v;
  varying vec3 n;
  void main() {
    float light = 0.5 + 0.5 * abs(normalize(n).z);
    float place = clamp((v - low) / (high - low), 0.0, 1.0);
    vec3 color = texture2D(colors, vec2((255.0 * place + 0.5) / 256.0, 0.5)).rgb
      * mix(1.0, light, shading);
    if (abs(v) < gray || v > 1e29)
      color = vec3(0.78, 0.81, 0.85) * light;
    gl_FragColor = vec4(color, 1.0);
  }`;

/* A color map, three bytes per color, as a texture. */
function texture(colors) {
  const bytes = Uint8Array.from(atob(colors), (letter) => letter.charCodeAt(0));
  const result = new THREE.DataTexture(bytes, bytes.length / 3, 1, THREE.RGBFormat);
  result.minFilter = result.magFilter = THREE.LinearFilter;
  result.needsUpdate = true;
  return result;
}

/* Lines in front of the surface on which they lie, and lines of a rigid body. */
function lines(color, opacity = 1) {
  const result = new THREE.LineSegments(
    new THREE.BufferGeometry(),
    new THREE.LineBasicMaterial({ color, opacity, transparent: opacity < 1 }));
  result.frustumCulled = false;
  return result;
}

function setPoints(object, numbers) {
  object.geometry.setAttribute(
    "position", new THREE.Float32BufferAttribute(numbers, 3));
}

/* Lines of the value 1/2, linear in each of some triangles: pairs of points. */
function contour(values, points, triangles) {
  const result = [];
  for (let t = 0; t < triangles.length; t += 3)
    for (let i = 0; i < 3; i++) {
      const [a, b] = [triangles[t + i], triangles[t + (i + 1) % 3]];
      const [low, high] = [values[a] - 0.5, values[b] - 0.5];
      if (low >= 0 === high >= 0)
        continue;
      const share = low / (low - high);
      for (let k = 0; k < 3; k++)
        result.push((1 - share) * points[3 * a + k] + share * points[3 * b + k]);
    }
  return result;
}

/* A rigid body as a pane with lines, from a grid of its points. */
async function paneOf(body) {
  const points = await unpacked(body.grid, Float32Array);
  const [rows, columns] = body.shape, triangles = [], pairs = [];
  const every = body.is_flat ? rows - 1 : 8;
  for (let i = 0; i < rows; i++)
    for (let j = 0; j < columns; j++) {
      const p = i * columns + j, right = p + 1, below = p + columns;
      if (i + 1 < rows && j + 1 < columns)
        triangles.push(p, right, below + 1, p, below + 1, below);
      if (j + 1 < columns && i % every === 0)
        pairs.push(p, right);
      if (i + 1 < rows && j % every === 0)
        pairs.push(p, below);
    }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
  geometry.setIndex(triangles);
  // behind everything, so that it does not tint the colors of the shell
  const pane = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
    color: 0xebf1f8, depthTest: false, depthWrite: false, side: THREE.DoubleSide }));
  pane.renderOrder = -1;
  pane.frustumCulled = false;
  const grid = lines(0x59738c);
  grid.geometry.setAttribute("position", geometry.getAttribute("position"));
  grid.geometry.setIndex(pairs);
  return new THREE.Group().add(pane, grid);
}
