// SPDX-License-Identifier: LGPL-2.1-or-later
/* Smooth cells through the nodes of a mesh of quadrilaterals. A side is a cubic whose
   tangent at each end is that of the circle through this node and its two neighbors on
   the line of the mesh, so that circles are circles, however long the cells are. The
   tangent is turned from the straight side at most by as much as the line turns at the
   other end: a straight side that ends at a bend stays straight. */
"use strict";

// The corners at the ends of the two sides of a cell along each coordinate
const SIDES = [[[0, 1], [3, 2]], [[0, 3], [1, 2]]];
// Pieces of a side at most, and so many that each turns by this angle
const MAXIMUM_PIECES = 8;
const ANGLE_OF_PIECE = 6 * Math.PI / 180;
// Points of all cells at most, unless the cells are straight
const MAXIMUM_POINTS = 200000;

class CurvedCells {
  /* From the nodes of each cell, in the order around it, and the number of nodes. */
  constructor(nodes, count) {
    this.nodes = nodes;
    this.count = nodes.length / 4;
    this.pieces = [1, 1];
    this.lines = SIDES.map((sides) => {
      const [before, after] = [0, 1].map(() => new Int32Array(count).fill(-1));
      const ends = [], numbers = new Int32Array(2 * this.count), seen = new Map();
      for (let cell = 0; cell < this.count; cell++)
        sides.forEach(([a, b], k) => {
          const start = nodes[4 * cell + a], end = nodes[4 * cell + b];
          after[start] = end;
          before[end] = start;
          const key = start * count + end;
          if (!seen.has(key)) {
            seen.set(key, ends.length / 2);
            ends.push(start, end);
          }
          numbers[2 * cell + k] = seen.get(key);
        });
      return { before, after, ends, numbers };
    });
  }

  /* Chooses how many pieces the sides have, for some positions of the nodes. */
  choosePieces(positions) {
    const turns = this.lines.map((line) => {
      let largest = 0;
      this.tangents(line, positions, (side, angle) => {
        largest = Math.max(largest, 2 * angle);
      });
      return largest;
    });
    this.pieces = turns.map((turn) => Math.min(MAXIMUM_PIECES,
      Math.max(1, Math.ceil(turn / ANGLE_OF_PIECE))));
    // fewer where they are straighter
    while (this.count * this.perCell > MAXIMUM_POINTS && Math.max(...this.pieces) > 1) {
      const [first, second] = this.pieces.map(
        (n, i) => n > 1 ? turns[i] / n : Infinity);
      this.pieces[first < second ? 0 : 1] -= 1;
    }
  }

  /* The points of a cell. */
  get perCell() {
    return (this.pieces[0] + 1) * (this.pieces[1] + 1);
  }

  /* The place of a corner among the points of its cell. */
  cornerPoint(corner) {
    const [n, m] = this.pieces;
    return Math.floor(corner / 4) * this.perCell
      + [0, n * (m + 1), n * (m + 1) + m, m][corner % 4];
  }

  /* Calls a function with each end of each side: the side, the angle between it and the
     tangent, and the tangent, of the length that the cubic needs. */
  tangents({ before, after, ends }, positions, use) {
    const at = (node) => new THREE.Vector3().fromArray(positions, 3 * node);
    const isInner = (node) => before[node] >= 0 && after[node] >= 0;
    const turns = new Map();
    const turnAt = (node) => {
      if (!turns.has(node)) {
        const [a, b, c] = [before[node], node, after[node]].map(at);
        const ahead = c.sub(b), back = b.sub(a);
        const angle = ahead.angleTo(back);
        const tangent = ahead.divideScalar(ahead.lengthSq() || 1)
          .addScaledVector(back, 1 / (back.lengthSq() || 1)).normalize();
        turns.set(node, { tangent, angle });
      }
      return turns.get(node);
    };
    for (let i = 0; i < ends.length; i++) {
      const node = ends[i], other = ends[i ^ 1], start = ends[i & ~1];
      const chord = at(ends[i | 1]).sub(at(start)), length = chord.length();
      chord.normalize();
      let tangent = chord.clone(), limit = Math.PI;
      if (isInner(node))
        tangent.copy(turnAt(node).tangent);
      else if (isInner(other)) {
        // the circle of the other end
        const there = turnAt(other).tangent;
        tangent.multiplyScalar(2 * there.dot(chord)).sub(there);
      }
      if (isInner(other))
        limit = turnAt(other).angle;
      const angle = Math.min(chord.angleTo(tangent) || 0, limit, Math.PI / 2);
      const across = tangent.addScaledVector(chord, -tangent.dot(chord)).normalize();
      tangent = chord.multiplyScalar(Math.cos(angle))
        .addScaledVector(across, Math.sin(angle))
        .multiplyScalar(2 * length / (1 + Math.cos(angle)));
      use(i >> 1, angle, tangent, i & 1);
    }
  }

  /* The points of all sides along a coordinate. */
  curves(coordinate, positions) {
    const line = this.lines[coordinate], n = this.pieces[coordinate];
    const result = new Float32Array(line.ends.length / 2 * (n + 1) * 3);
    this.tangents(line, positions, (side, angle, tangent, isEnd) => {
      const node = 3 * line.ends[2 * side + isEnd];
      for (let j = 0; j <= n; j++) {
        const s = isEnd ? 1 - j / n : j / n;
        const value = 1 - 3 * s ** 2 + 2 * s ** 3;
        const slope = (isEnd ? -1 : 1) * s * (1 - s) ** 2;
        AXES.forEach((axis, k) => {
          result[3 * (side * (n + 1) + j) + k]
            += value * positions[node + k] + slope * tangent[axis];
        });
      }
    });
    return result;
  }

  /* Points and normals of all cells, which blend the curves of their four sides, and
     these curves. */
  shape(positions) {
    const curves = [0, 1].map((coordinate) => this.curves(coordinate, positions));
    const [n, m] = this.pieces, perCell = this.perCell;
    const points = new Float32Array(3 * this.count * perCell);
    const normals = new Float32Array(points.length);
    for (let cell = 0; cell < this.count; cell++) {
      const [low, high, left, right] = [0, 0, 1, 1].map((c, i) =>
        3 * this.lines[c].numbers[2 * cell + i % 2] * (this.pieces[c] + 1));
      const corners = [0, 1, 2, 3].map((i) => 3 * this.nodes[4 * cell + i]);
      for (let i = 0; i <= n; i++)
        for (let j = 0; j <= m; j++) {
          const s = i / n, t = j / m, p = 3 * (cell * perCell + i * (m + 1) + j);
          for (let k = 0; k < 3; k++)
            points[p + k] = (1 - t) * curves[0][low + 3 * i + k]
              + t * curves[0][high + 3 * i + k]
              + (1 - s) * curves[1][left + 3 * j + k] + s * curves[1][right + 3 * j + k]
              - (1 - s) * (1 - t) * positions[corners[0] + k]
              - s * (1 - t) * positions[corners[1] + k]
              - s * t * positions[corners[2] + k]
              - (1 - s) * t * positions[corners[3] + k];
        }
      this.addNormals(cell, points, normals);
    }
    return { points, normals, curves };
  }

  /* The normals of a cell, from the differences between its points. */
  addNormals(cell, points, normals) {
    const [n, m] = this.pieces, first = cell * this.perCell;
    const at = (i, j) => 3 * (first + i * (m + 1) + j);
    for (let i = 0; i <= n; i++)
      for (let j = 0; j <= m; j++) {
        const a = at(Math.max(i - 1, 0), j), b = at(Math.min(i + 1, n), j);
        const c = at(i, Math.max(j - 1, 0)), d = at(i, Math.min(j + 1, m));
        const p = at(i, j);
        for (let k = 0; k < 3; k++) {
          const x = (k + 1) % 3, y = (k + 2) % 3;
          normals[p + k] =
            (points[b + x] - points[a + x]) * (points[d + y] - points[c + y])
            - (points[b + y] - points[a + y]) * (points[d + x] - points[c + x]);
        }
      }
  }

  /* Values at all points, bilinear between the corners, of which a function gives the
     values. */
  values(valueAt) {
    const [n, m] = this.pieces, result = new Float32Array(this.count * this.perCell);
    let place = 0;
    for (let cell = 0; cell < this.count; cell++) {
      const [a, b, c, d] = [0, 1, 2, 3].map((i) => valueAt(4 * cell + i));
      for (let i = 0; i <= n; i++)
        for (let j = 0; j <= m; j++) {
          const s = i / n, t = j / m;
          result[place++] = (1 - s) * ((1 - t) * a + t * d) + s * ((1 - t) * b + t * c);
        }
    }
    return result;
  }

  /* The triangles of the cells: three points each. */
  triangles() {
    const [n, m] = this.pieces, result = [];
    for (let cell = 0; cell < this.count; cell++)
      for (let i = 0; i < n; i++)
        for (let j = 0; j < m; j++) {
          const p = cell * this.perCell + i * (m + 1) + j, next = p + m + 1;
          result.push(p, next, next + 1, p, next + 1, p + 1);
        }
    return result;
  }

  /* Pairs of points of the curves, those of the second coordinate after those of the
     first: the sides of some cells, each once. */
  sides(first, count) {
    const result = [];
    let before = 0;
    this.lines.forEach(({ ends, numbers }, coordinate) => {
      const n = this.pieces[coordinate];
      for (const side of new Set(numbers.subarray(2 * first, 2 * (first + count))))
        for (let j = 0; j < n; j++)
          result.push(before + side * (n + 1) + j, before + side * (n + 1) + j + 1);
      before += ends.length / 2 * (n + 1);
    });
    return result;
  }
}
