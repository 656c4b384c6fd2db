// How a plan is drawn: plain SVG from what the server tells. Lengths are metres, the plan's y points
// up, the screen's down.
const SVG = "http://www.w3.org/2000/svg", MARGIN = 0.6;

export function element(name, attributes = {}, parent = null, text = "") {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text) made.textContent = text;
  if (parent) parent.append(made);
  return made;
}

export const outline = (rings) => rings.map((ring) => "M" + ring.map(([x, y]) => `${x},${-y}`).join(" ") + "Z").join("");
export const line = (points) => "M" + points.map(([x, y]) => `${x},${-y}`).join(" ");
export const placed = ([x, y, , heading]) => `translate(${x} ${-y}) rotate(${90 - heading * 180 / Math.PI})`;

export function drawFloor(here, parent) {
  for (const one of here.spaces) element("path", { class: "space", d: outline(one.rings), "fill-rule": "evenodd", "data-space": one.id }, parent);
  for (const one of here.surfaces) element("path", { class: "ground", d: outline(one.rings) }, parent);
}

export function drawShell(here, parent) {
  for (const one of here.walls) element("path", { class: one.low ? "low" : "wall", d: outline(one.rings) }, parent);
  for (const one of here.openings) drawOpening(one, parent);
}

function drawOpening(one, plan) {
  const [x, y] = one.at, [ux, uy] = one.along, half = one.width / 2;
  const a = [x - ux * half, y - uy * half], b = [x + ux * half, y + uy * half];
  if (one.kind === "window") { element("path", { class: "opening", d: line([a, b]) }, plan); return; }
  if (!one.hinge || !one.swing) return;
  const at = one.hinge < 0 ? a : b, far = one.hinge < 0 ? b : a;
  const tip = [at[0] - uy * one.swing * one.width, at[1] + ux * one.swing * one.width];
  const sweep = one.hinge * one.swing < 0 ? 0 : 1;
  const arc = ` A${one.width} ${one.width} 0 0 ${1 - sweep} ${far[0]},${-far[1]}`;
  element("path", { class: "opening door", d: line([at, tip]) + arc }, plan);
}

export function extent(here) {
  const points = here.spaces.flatMap((one) => one.rings[0]);
  const xs = points.map((p) => p[0]), ys = points.map((p) => -p[1]);
  const margin = Math.max(MARGIN, 0.03 * (Math.max(...xs) - Math.min(...xs)));
  const x = Math.min(...xs) - margin, y = Math.min(...ys) - margin;
  return [x, y, Math.max(...xs) + margin - x, Math.max(...ys) + margin - y];
}

// A layout as a small picture: its levels side by side, a path a piece.
export function drawCard(card, parent) {
  let right = 0, bottom = 0;
  for (const here of card.levels) {
    const [x, y, width, height] = extent(here);
    const group = element("g", { transform: `translate(${right - x} ${-y})` }, parent);
    drawFloor(here, group);
    for (const [look, level, px, py, heading] of card.pieces) {
      if (card.levels[level] !== here || !look) continue;
      element("path", { class: "item", d: look.lines.map(line).join(""), transform: placed([px, py, 0, heading]) }, group);
    }
    drawShell(here, group);
    right += width; bottom = Math.max(bottom, height);
  }
  parent.setAttribute("viewBox", `0 0 ${right} ${bottom}`);
}
