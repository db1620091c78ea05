// SPDX-License-Identifier: LGPL-2.1-or-later
/* A view of a shell that one can turn, in each <figure class="view">. The <script> that
   its attribute data-scene names has the data, see view.py and view_data.py. Needs
   three.js with its OrbitControls. */
"use strict";

const NO_VALUE = 1e30;      // in the shader: a corner without a value
const GRAY_BELOW = 0.01;    // of the range, in fields that vanish outside the zone
const STEP_TIME = 400;      // milliseconds per step
const PERIOD = 2000;        // milliseconds per period of a mode
const ARROW = 0.035;        // the longest arrow, relative to the size of the shell

/* A number with three digits. */
function words(number) {
  const size = Math.abs(number);
  return (size !== 0 && (size < 1e-3 || size >= 1e5)
    ? number.toExponential(2) : String(+number.toPrecision(3))).replaceAll("-", "−");
}

/* An element with attributes and children. */
function element(tag, attributes = {}, ...children) {
  const result = Object.assign(document.createElement(tag), attributes);
  result.append(...children);
  return result;
}

class View {
  constructor(figure, data) {
    this.figure = figure;
    this.data = data;
    this.parts = data.parts.map((part) => new Part(part));
    this.textures = {};
    this.phase = 0;
    this.addObjects();
    this.addStage();
    this.addControls();
    // what is awaited to know that the view is up to date
    this.ready = this.start();
  }

  async start() {
    for (const body of this.data.bodies) {
      body.object = await paneOf(body);
      this.bodies.add(body.object);
    }
    await this.update();
    this.reset();
    new ResizeObserver(() => this.resize()).observe(this.stage);
  }

  /* What is drawn. */
  addObjects() {
    this.renderer = new THREE.WebGLRenderer(
      { antialias: true, preserveDrawingBuffer: true });
    this.renderer.setClearColor(0xffffff);
    this.renderer.autoClear = false;
    this.uniforms = { colors: {}, low: {}, high: {}, gray: {}, shading: {} };
    this.surface = new THREE.Mesh(new THREE.BufferGeometry(),
      new THREE.ShaderMaterial({
        vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: this.uniforms,
        side: THREE.DoubleSide, polygonOffset: true, polygonOffsetFactor: 2,
        polygonOffsetUnits: 4 }));
    this.surface.frustumCulled = false;
    this.mesh = lines(0x000000, 0.28);
    this.edge = lines(0x000000);
    this.arrows = lines(0x000000);
    // drawn once for each copy of a sector
    this.shell = new THREE.Group();
    this.shell.matrixAutoUpdate = false;
    this.shell.add(this.surface, this.mesh, this.edge, this.arrows);
    this.bodies = new THREE.Group();
    this.scene = new THREE.Scene();
    this.scene.add(this.shell, this.bodies);
  }

  /* Where it is drawn, and how it is turned. */
  addStage() {
    const canvas = this.canvas = this.renderer.domElement;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    this.axes = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    this.axes.setAttribute("viewBox", "-50 -50 100 100");
    this.axes.setAttribute("aria-hidden", "true");
    this.bar = element("div", { className: "bar" });
    this.stage = element("div", { className: "stage" }, canvas, this.axes, this.bar);
    this.camera = new THREE.OrthographicCamera();
    this.camera.up.fromArray(this.data.up);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.screenSpacePanning = true;
    this.controls.enableKeys = false;
    // the wheel scrolls the page until the view is chosen
    this.controls.enableZoom = false;
    canvas.addEventListener("focus", () => { this.controls.enableZoom = true; });
    canvas.addEventListener("blur", () => { this.controls.enableZoom = false; });
    canvas.addEventListener("keydown", (event) => this.key(event));
    this.controls.addEventListener("change", () => this.render());
  }

  addControls() {
    const { is_series: isSeries, copies, bodies } = this.data;
    const labelled = (label, input, action = () => this.request()) => {
      input.addEventListener("input", action);
      return element("label", {}, label + " ", input);
    };
    const box = (name, label, checked, isHidden = false) => {
      this[name] = element("input", { type: "checkbox", checked });
      this[name].addEventListener("change", () => this.request());
      return element("label", { hidden: isHidden }, this[name], " " + label);
    };
    const button = (label, action, title = "") => {
      const result = element("button", { type: "button", title }, label);
      result.addEventListener("click", action);
      return result;
    };
    const [part, color, vectors, turn] = [0, 1, 2, 3].map(() => element("select"));
    Object.assign(this, { part, color, vectors, turn });
    this.parts.forEach((meshes, p) => meshes.groups.forEach(([name], g) =>
      part.add(new Option(`${meshes.name}, ${name}`, `${p} ${g}`))));
    for (const [name, count] of [["the sector", 1],
      ["half a turn", Math.ceil(copies.length / 2)], ["a full turn", copies.length]])
      turn.add(new Option(name, count));
    turn.selectedIndex = 1;
    const around = labelled("Around", turn, () => this.reset());
    around.hidden = copies.length === 1;
    this.state = element("input", { type: "range", min: 0, step: 1 });
    this.label = element("output");
    this.play = button("Play", () => this.togglePlay());
    this.scale = isSeries
      ? element("input", { type: "range", min: 0, max: 0.3, step: 0.01, value: 0.1 })
      : element("input", { type: "number", min: 0, step: "any", value: 1 });
    this.figure.prepend(
      element("div", { className: "controls" },
        labelled("Show", part), labelled("Color", color), labelled("Arrows", vectors),
        labelled(isSeries ? "Amplitude" : "Displacements ×", this.scale)),
      this.stage,
      element("div", { className: "controls" }, this.play,
        labelled(isSeries ? "Shape" : "Step", this.state), this.label),
      element("div", { className: "controls" },
        box("hasMesh", "Mesh", true), box("hasShading", "Shading", false),
        box("hasBodies", "Rigid bodies", true, bodies.length === 0),
        box("hasEdge", "Edge of contact", true,
          !this.parts.some((meshes) => meshes.field("active"))),
        box("isFixed", "Same range in all steps", !isSeries, isSeries), around,
        ...AXES.map((axis, i) => button(axis, () => this.look(i),
          `Look against the ${axis} axis`)),
        button("Reset view", () => this.reset())));
  }

  /* Draws what the controls say, once what is being drawn is done. */
  request() {
    if (this.isRequested)
      return;
    this.isRequested = true;
    this.ready = this.ready.then(() => {
      this.isRequested = false;
      return this.update();
    });
  }

  /* Makes room for a part, and fills the menus with what it has. */
  async choose(part) {
    const color = this.color.value, isFirst = !this.chosen;
    const atEnd = isFirst || +this.state.value === +this.state.max;
    const shown = isFirst ? -1
      : part.states.indexOf(this.chosen.states[this.state.value]);
    this.chosen = part;
    this.fillMenus(part);
    this.color.value = color;
    if (!this.color.value)
      this.color.value = `${part.field(this.data.color) ? this.data.color
        : part.motion} -1`;
    this.state.max = part.states.length - 1;
    this.state.value = this.data.is_series ? 0
      : atEnd || shown < 0 ? this.state.max : shown;
    await part.load([part.motion]);
    const { cells } = part;
    cells.choosePieces(part.positions(part.states.length - 1, [[part.motion, 1]]));
    this.surface.geometry.dispose();
    this.surface.geometry = new THREE.BufferGeometry();
    this.surface.geometry.setIndex(cells.triangles());
    for (const [name, size] of [["position", 3], ["normal", 3], ["value", 1]])
      this.surface.geometry.setAttribute(name, new THREE.BufferAttribute(
        new Float32Array(size * cells.count * cells.perCell), size));
  }

  fillMenus(part) {
    this.color.replaceChildren();
    this.vectors.replaceChildren(new Option("none", ""));
    for (const { name, components } of part.fields) {
      if (name === "motion")
        continue;
      this.color.add(new Option(components === 1 ? name : `${name}, magnitude`,
        `${name} -1`));
      if (components === 1)
        continue;
      AXES.forEach((axis, i) =>
        this.color.add(new Option(`${name}, ${axis}`, `${name} ${i}`)));
      this.vectors.add(new Option(name, name));
    }
  }

  /* Draws what the controls say. */
  async update() {
    const [p, group] = this.part.value.split(" ").map(Number);
    this.group = group;
    if (this.parts[p] !== this.chosen)
      await this.choose(this.parts[p]);
    const part = this.chosen;
    const [name, component] = this.color.value.split(" ");
    await part.load([part.motion, "active", "mode", "mode_imaginary", name,
                     this.vectors.value]);
    const state = +this.state.value, field = part.field(name);
    const [, first, count] = part.groups[this.group];
    const perCell = 6 * part.cells.pieces[0] * part.cells.pieces[1];
    this.surface.geometry.setDrawRange(first * perCell, count * perCell);
    this.mesh.geometry.setIndex(part.cells.sides(first, count));
    this.setColors(part, field, +component, state);
    this.place();
    for (const body of this.data.bodies) {
      const place = body.places[part.states[state]];
      body.object.visible = this.hasBodies.checked && Boolean(place);
      if (place)
        body.object.position.fromArray(place);
    }
    this.label.value = part.states[state];
    this.canvas.setAttribute("aria-label", `${this.data.title}, `
      + `${part.states[state]}, colored by ${this.color.selectedOptions[0].text} from `
      + `${words(this.uniforms.low.value)} to ${words(this.uniforms.high.value)}. `
      + "Arrow keys turn, with Shift they move, + and − zoom, Home resets.");
    this.render();
  }

  /* Moves the points. */
  place() {
    const part = this.chosen, state = +this.state.value;
    const terms = [[part.motion, this.data.is_series ? 1 : +this.scale.value]];
    if (this.data.is_series) {
      const size = this.scale.value * this.data.size;
      terms.push(["mode", size * Math.cos(this.phase)]);
      if (part.field("mode_imaginary"))
        terms.push(["mode_imaginary", -size * Math.sin(this.phase)]);
    }
    this.nodes = part.positions(state, terms);
    const { points, normals, curves } = part.cells.shape(this.nodes);
    const { attributes, index, drawRange } = this.surface.geometry;
    attributes.position.array.set(points);
    attributes.normal.array.set(normals);
    attributes.position.needsUpdate = attributes.normal.needsUpdate = true;

    this.mesh.visible = this.hasMesh.checked;
    const lines = new Float32Array(curves[0].length + curves[1].length);
    lines.set(curves[0]);
    lines.set(curves[1], curves[0].length);
    setPoints(this.mesh, lines);
    const active = part.field("active");
    this.edge.visible = Boolean(active) && this.hasEdge.checked;
    if (this.edge.visible) {
      const { start, count } = drawRange;
      setPoints(this.edge, contour(
        part.cells.values((corner) => part.value(active, state, corner, -1)),
        points, index.array.subarray(start, start + count)));
    }
    const vectors = part.field(this.vectors.value);
    this.arrows.visible = Boolean(vectors);
    if (vectors)
      setPoints(this.arrows, this.arrowLines(vectors, state, normals));
  }

  /* Arrows at the corners of the group, each node once, as pairs of points. */
  arrowLines(field, state, normals) {
    const part = this.chosen, result = [], seen = new Set();
    const [, first, count] = part.groups[this.group];
    const corners = [];
    let longest = 0;
    for (let c = 4 * first; c < 4 * (first + count); c++) {
      if (field.at_nodes && seen.has(part.nodes[c]))
        continue;
      seen.add(part.nodes[c]);
      corners.push(c);
      longest = Math.max(longest, part.value(field, state, c, -1) || 0);
    }
    const [start, along, side, tip] = [0, 1, 2, 3].map(() => new THREE.Vector3());
    for (const c of corners) {
      if (!(part.value(field, state, c, -1) > 1e-3 * longest))
        continue;
      start.fromArray(this.nodes, 3 * part.nodes[c]);
      along.set(...AXES.map((_, i) => part.value(field, state, c, i)));
      along.multiplyScalar(ARROW * this.data.size / longest);
      side.fromArray(normals, 3 * part.cells.cornerPoint(c)).cross(along);
      side.setLength(0.12 * along.length());
      tip.copy(start).add(along);
      const neck = start.clone().addScaledVector(along, 0.72);
      for (const point of [start, tip, tip, neck.clone().add(side), tip,
                           neck.clone().sub(side)])
        result.push(point.x, point.y, point.z);
    }
    return result;
  }

  /* The values at all corners, their range and its bar. */
  setColors(part, field, component, state) {
    const attribute = this.surface.geometry.getAttribute("value");
    const [, first, count] = part.groups[this.group];
    const states = this.isFixed.checked ? part.states.keys() : [state];
    let low = Infinity, high = -Infinity;
    for (const s of states)
      for (let c = 4 * first; c < 4 * (first + count); c++) {
        const value = part.value(field, s, c, component);
        if (value < low) low = value;
        if (value > high) high = value;
      }
    attribute.array.set(part.cells.values((corner) => {
      const value = part.value(field, state, corner, component);
      return Number.isNaN(value) ? NO_VALUE : value;
    }));
    attribute.needsUpdate = true;
    if (!(low <= high))
      low = high = 0;
    // magnitudes, and constants with their round-off, start at zero
    if (field.components > 1 && component < 0)
      low = 0;
    else if (high - low < 1e-4 * Math.max(Math.abs(low), Math.abs(high)))
      [low, high] = [Math.min(low, 0), Math.max(high, 0)];
    const colors = this.data.colors[field.colors];
    this.textures[field.colors] ||= texture(colors);
    this.uniforms.colors.value = this.textures[field.colors];
    this.uniforms.low.value = low;
    this.uniforms.high.value = high > low ? high : 1;
    this.uniforms.gray.value = field.in_zone
      ? GRAY_BELOW * Math.max(Math.abs(low), Math.abs(high)) || 1e-30 : -1;
    this.uniforms.shading.value = +this.hasShading.checked;
    this.drawBar(colors, field);
  }

  drawBar(colors, field) {
    const bytes = atob(colors), stops = [], numbers = element("ol");
    const { low, high } = this.uniforms;
    for (let i = 0; i < bytes.length; i += 15)
      stops.push(`rgb(${[0, 1, 2].map((k) => bytes.charCodeAt(i + k))})`);
    for (let i = 4; i >= 0; i--)
      numbers.append(element("li", {},
        words(low.value + (high.value - low.value) * i / 4)));
    const strip = element("div");
    strip.style.background = `linear-gradient(to top, ${stops})`;
    this.bar.replaceChildren(
      element("p", {}, this.color.selectedOptions[0].text
        + (field.unit ? ` [${field.unit}]` : "")),
      strip, numbers);
  }

  // -------------------------------------------------------------- camera

  /* The matrices of the copies that are drawn. */
  copies() {
    return this.data.copies.slice(0, this.turn.value)
      .map(([a, b, c, d]) => new THREE.Matrix4().set(
        a, 0, b, 0, 0, 1, 0, 0, c, 0, d, 0, 0, 0, 0, 1));
  }

  /* Half the extents of the shell in a frame, and their middle. */
  extents(frame) {
    const points = this.surface.geometry.getAttribute("position");
    const box = new THREE.Box3(), point = new THREE.Vector3();
    for (const copy of this.copies()) {
      const matrix = copy.premultiply(frame);
      for (let i = 0; i < points.count; i++)
        box.expandByPoint(point.fromBufferAttribute(points, i).applyMatrix4(matrix));
    }
    return [box.getSize(new THREE.Vector3()).multiplyScalar(0.5),
      box.getCenter(new THREE.Vector3())];
  }

  /* Looks at the middle from a direction, so that all of the shell is seen. */
  lookFrom(direction) {
    const { camera, controls } = this;
    camera.position.copy(direction);
    camera.lookAt(0, 0, 0);
    camera.updateMatrixWorld();
    const [extent, middle] = this.extents(
      new THREE.Matrix4().extractRotation(camera.matrixWorldInverse));
    this.extent = extent;
    controls.target.copy(middle).applyQuaternion(camera.quaternion);
    // room for enlarged displacements
    const reach = 6 * Math.max(extent.x, extent.y, extent.z);
    camera.position.copy(direction).setLength(reach).add(controls.target);
    camera.near = 0;
    camera.far = 2 * reach;
    camera.zoom = 1;
    this.resize();
  }

  reset() {
    this.lookFrom(new THREE.Vector3().fromArray(this.data.direction));
  }

  look(axis) {
    const direction = new THREE.Vector3();
    direction.setComponent(axis, 1);
    this.lookFrom(direction);
  }

  resize() {
    const width = this.stage.clientWidth, height = this.stage.clientHeight;
    if (width === 0)
      return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
    // the bar takes some of the width; shapes move
    const half = (this.data.is_series ? 1.3 : 1.08) * Math.max(this.extent.y,
      this.extent.x * height / Math.max(width - 130, 0.6 * width));
    const { camera } = this;
    camera.top = half;
    camera.bottom = -half;
    camera.left = -half * width / height;
    camera.right = -camera.left;
    camera.updateProjectionMatrix();
    this.controls.update();
    this.render();
  }

  key(event) {
    const turn = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, -1],
      ArrowDown: [0, 1] }[event.key];
    const zoom = { "+": 1.15, "=": 1.15, "-": 1 / 1.15 }[event.key];
    const { camera, controls } = this;
    if (event.ctrlKey || event.altKey || event.metaKey
        || !(turn || zoom || event.key === "Home"))
      return;
    event.preventDefault();
    if (event.key === "Home")
      return this.reset();
    if (zoom)
      camera.zoom *= zoom;
    else if (event.shiftKey) {
      const step = 0.05 * (camera.top - camera.bottom) / camera.zoom;
      const move = new THREE.Vector3(turn[0] * step, turn[1] * step, 0)
        .applyQuaternion(camera.quaternion);
      camera.position.add(move);
      controls.target.add(move);
    } else {
      const angle = -5 * Math.PI / 180;
      const right = new THREE.Vector3(1, 0, 0).applyQuaternion(camera.quaternion);
      const arm = camera.position.clone().sub(controls.target);
      arm.applyAxisAngle(camera.up, -angle * turn[0]);
      // not over the poles
      const high = arm.clone().applyAxisAngle(right, -angle * turn[1]);
      if (Math.abs(high.angleTo(camera.up) - Math.PI / 2) < 0.49 * Math.PI)
        arm.copy(high);
      camera.position.copy(controls.target).add(arm);
    }
    camera.updateProjectionMatrix();
    controls.update();
    this.render();
  }

  render() {
    this.renderer.clear();
    this.bodies.visible = true;
    for (const copy of this.copies()) {
      this.shell.matrix.copy(copy);
      this.shell.matrixWorldNeedsUpdate = true;
      this.renderer.render(this.scene, this.camera);
      this.bodies.visible = false;
    }
    this.axes.replaceChildren();
    const inverse = this.camera.quaternion.clone().inverse();
    AXES.forEach((axis, i) => {
      const tip = new THREE.Vector3();
      tip.setComponent(i, 1);
      tip.applyQuaternion(inverse);
      const [x, y] = [36 * tip.x, -36 * tip.y];
      const make = (tag, attributes) => {
        const item = document.createElementNS(this.axes.namespaceURI, tag);
        for (const [name, value] of Object.entries(attributes))
          item.setAttribute(name, value);
        this.axes.append(item);
        return item;
      };
      if (Math.hypot(x, y) < 3)
        return;
      make("line", { x2: x, y2: y, stroke: "#444", "stroke-width": 1.6 });
      make("text", { x: 1.22 * x, y: 1.22 * y }).textContent = axis;
    });
  }

  // -------------------------------------------------------------- motion

  togglePlay() {
    this.isMoving = !this.isMoving;
    this.play.textContent = this.isMoving ? "Stop" : "Play";
    let last = performance.now();
    const move = async (now) => {
      if (!this.isMoving)
        return;
      if (this.data.is_series) {
        this.phase += 2 * Math.PI * Math.min(now - last, 100) / PERIOD;
        last = now;
        this.place();
        this.render();
      } else if (now - last > STEP_TIME) {
        last = now;
        const next = +this.state.value + 1;
        this.state.value = next > +this.state.max ? 0 : next;
        this.request();
        await this.ready;
      }
      requestAnimationFrame(move);
    };
    requestAnimationFrame(move);
  }
}

for (const figure of document.querySelectorAll("figure.view")) {
  const fail = (reason) => figure.prepend(
    element("p", { className: "warning" }, reason));
  try {
    if (!window.DecompressionStream)
      throw new Error("This browser is too old for the view.");
    const data = document.getElementById(figure.dataset.scene).textContent;
    figure.view = new View(figure, JSON.parse(data));
    figure.view.ready.catch((error) => fail(error.message));
  } catch (error) {
    fail(document.createElement("canvas").getContext("webgl")
      ? error.message : "The view needs WebGL, which this browser lacks.");
  }
}
