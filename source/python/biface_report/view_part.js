// SPDX-License-Identifier: LGPL-2.1-or-later
/* The meshes of a view and their fields, as view_data.py packs them. */
"use strict";

const AXES = ["x", "y", "z"];

/* The numbers in a compressed text. */
async function unpacked(text, Type) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream()
    .pipeThrough(new DecompressionStream("deflate"));
  return new Type(await new Response(stream).arrayBuffer());
}

/* A mesh of quadrilaterals with fields in several states. */
class Part {
  constructor(data) {
    Object.assign(this, data);
  }

  field(name) {
    return this.fields.find((field) => field.name === name);
  }

  /* Unpacks the mesh and some fields, unless that is done. */
  async load(names) {
    if (typeof this.base === "string")
      [this.base, this.nodes] = await Promise.all(
        [unpacked(this.base, Float32Array), unpacked(this.nodes, Int32Array)]);
    this.cells ||= new CurvedCells(this.nodes, this.base.length / 3);
    for (const field of this.fields)
      if (names.includes(field.name) && typeof field.values === "string")
        field.values = await unpacked(field.values, Int16Array);
  }

  /* A value of a field at a corner; component -1 is the magnitude. */
  value(field, state, corner, component) {
    const n = field.components, scale = field.scales[state];
    const count = field.at_nodes ? this.base.length / 3 : this.nodes.length;
    const row = field.at_nodes ? this.nodes[corner] : corner;
    const first = (state * count + row) * n;
    if (field.values[first] === -32768)
      return NaN;
    if (component >= 0 || n === 1)
      return scale * field.values[first + Math.max(component, 0)];
    let squares = 0;
    for (let i = first; i < first + n; i++)
      squares += field.values[i] ** 2;
    return scale * Math.sqrt(squares);
  }

  /* The positions of all nodes: each of the terms moves them by a factor times a
     field. */
  positions(state, terms) {
    const result = this.base.slice();
    for (const [name, factor] of terms) {
      const field = this.field(name);
      const scale = factor * field.scales[state];
      const first = state * result.length;
      for (let i = 0; i < result.length; i++)
        result[i] += scale * field.values[first + i];
    }
    return result;
  }
}
