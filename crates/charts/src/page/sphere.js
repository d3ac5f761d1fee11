// Turns the spheres. Without this script they stand as first drawn.
"use strict";
for (const card of document.querySelectorAll("[data-sphere]")) {
  const data = JSON.parse(card.dataset.sphere);
  const shared = JSON.parse(card.closest("[data-shared]").dataset.shared);
  const svg = card.querySelector("svg");
  const layer = svg.querySelector(".turning");
  const readout = card.querySelector(".readout");
  const output = readout.querySelector("output");
  const hint = output.value;
  const LEVELS = 12;
  const [cx, cy] = data.centre;
  let [azimuth, height] = data.view;
  let basis;

  const dot = (a, x, y, z) => a[0] * x + a[1] * y + a[2] * z;
  const place = (x, y, z) => [
    cx + data.radius * dot(basis.right, x, y, z),
    cy - data.radius * dot(basis.up, x, y, z),
    dot(basis.towards, x, y, z),
  ];
  const level = (value) => {
    const [low, high, at] = [data.range[0], data.range[1], value].map((x) => Math.asinh(x / data.range[2]));
    const share = high > low ? (at - low) / (high - low) : 0.5;
    return Math.max(0, Math.min(LEVELS - 1, Math.floor(share * LEVELS)));
  };
  const look = () => {
    const a = (azimuth * Math.PI) / 180, h = (height * Math.PI) / 180;
    const [sa, ca, sh, ch] = [Math.sin(a), Math.cos(a), Math.sin(h), Math.cos(h)];
    basis = { right: [-sa, ca, 0], up: [-sh * ca, -sh * sa, ch], towards: [ch * ca, ch * sa, sh] };
  };

  const element = (parent, name, attributes, text) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    if (text !== undefined) made.textContent = text;
    return parent.appendChild(made);
  };

  // Splits a strand into stretches of one side and one colour.
  const strand = ([kind, , points, values], layers) => {
    const flush = (piece) => piece && element(layers[piece.side], "path", { class: piece.kind, d: piece.d });
    let piece, from;
    for (let i = 0; i * 3 < points.length; i++) {
      const to = place(points[3 * i] / 1e3, points[3 * i + 1] / 1e3, points[3 * i + 2] / 1e3);
      if (from) {
        const side = from[2] + to[2] >= 0 ? 1 : 0;
        const valued = data.range && values && values[i] !== null && values[i - 1] !== null;
        const own = valued ? `valued v${level((values[i] + values[i - 1]) / 2)}` : kind;
        if (!piece || piece.side !== side || piece.kind !== own) {
          flush(piece);
          piece = { side, kind: own, d: `M${from[0].toFixed(1)} ${from[1].toFixed(1)}L` };
        }
        piece.d += `${to[0].toFixed(1)} ${to[1].toFixed(1)} `;
      }
      from = to;
    }
    flush(piece);
  };

  const draw = () => {
    look();
    layer.replaceChildren();
    const layers = ["back", "front"].map((name) => element(layer, "g", { class: name }));
    for (const each of [...shared, ...data.strands]) strand(each, layers);
    data.axes.forEach((name, i) => {
      const [x, y, depth] = place(...[0, 1, 2].map((j) => (i === j ? 1.3 : 0)));
      element(layers[depth >= 0 ? 1 : 0], "text", { class: "axis-name", x, y: y + 5, "text-anchor": "middle" }, name);
    });
    for (const [px, py, pz, name, note, hollow] of data.marks) {
      const [x, y, depth] = place(px / 1e3, py / 1e3, pz / 1e3);
      const side = layers[depth >= 0 ? 1 : 0];
      const circle = element(side, "circle", { class: hollow ? "hole" : "dot", cx: x, cy: y, r: 5 });
      element(circle, "title", {}, note);
      element(side, "text", { class: "mark-name", x: x + 9, y: y - 6 }, name);
    }
  };

  let pending = false;
  const redraw = () => {
    if (pending) return;
    pending = true;
    requestAnimationFrame(() => { pending = false; draw(); });
  };
  const turn = (right, up) => {
    azimuth = (azimuth - right) % 360;
    height = Math.max(-90, Math.min(90, height + up));
    redraw();
  };

  // The nearest point of a curve on the near side.
  const read = (event) => {
    const box = svg.getBoundingClientRect();
    const scale = svg.viewBox.baseVal.width / box.width;
    const [mx, my] = [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
    let best = 14, found;
    for (const [kind, name, points, values] of data.strands) {
      if (!kind.startsWith("curve")) continue;
      for (let i = 0; i * 3 < points.length; i++) {
        const at = [0, 1, 2].map((j) => points[3 * i + j] / 1e3);
        const [x, y, depth] = place(...at);
        const away = depth >= 0 ? Math.hypot(x - mx, y - my) : Infinity;
        if (away < best) [best, found] = [away, { name, at, value: values && values[i] }];
      }
    }
    if (!found) return (output.value = hint);
    const at = found.at.map((x) => Number((x * data.length).toPrecision(4))).join(", ");
    const value = found.value == null ? "" : `; ${data.value}: ${Number(found.value.toPrecision(4))}`;
    const name = found.name ? `${found.name}: ` : "";
    output.value = name + `(${at})${value}`.replaceAll("-", "−");
  };

  let held;
  svg.addEventListener("pointerdown", (event) => {
    held = event;
    svg.setPointerCapture(event.pointerId);
    read(event);
  });
  svg.addEventListener("pointermove", (event) => {
    if (!held) return read(event);
    const box = svg.getBoundingClientRect();
    turn(((event.clientX - held.clientX) / box.width) * 160, ((event.clientY - held.clientY) / box.width) * 160);
    held = event;
  });
  for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => (held = undefined));
  const keys = { ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, -6], ArrowDown: [0, 6] };
  svg.addEventListener("keydown", (event) => {
    if (!keys[event.key]) return;
    event.preventDefault();
    turn(...keys[event.key]);
  });
  readout.querySelector("button").addEventListener("click", () => {
    [azimuth, height] = data.view;
    redraw();
  });
  svg.setAttribute("tabindex", "0");
  svg.setAttribute("aria-label", `${svg.getAttribute("aria-label")}. Arrow keys turn the sphere.`);
  readout.hidden = false;
  look();
}
