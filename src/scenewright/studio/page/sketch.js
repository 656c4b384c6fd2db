// A drawing as SVG: outlines with their lengths, openings, stairs, streets, faults where they lie.
import { element, line, outline } from "/draw.js";
import { t } from "/words.js";
import { far, middle, nearestSide, shifted, sides } from "/snapping.js";

const HAIR = 1.5;
// Outlines of what was drawn here are the middles of walls, those of a plan that was brought their faces.
export const isInner = (draft) => draft.kept?.outlines === "inner";

// ``at`` holds what is shown: the draft, its storey, the frame, what is picked, moved and begun.
export function drawSketch(svg, at) {
  const { draft, view, px, shift, picked } = at, on = (group) => draft[group].filter((one) => one.level === at.level);
  svg.setAttribute("viewBox", view.join(" "));
  svg.replaceChildren();
  if (at.under) element("image", { href: at.under.href, x: 0, y: -at.under.width * at.under.tall, width: at.under.width, height: at.under.width * at.under.tall, opacity: 0.55 }, svg);
  drawGrid(svg, view, px);
  const below = draft.levels[draft.levels.findIndex((one) => one.id === at.level) - 1];
  for (const room of draft.rooms) if (room.level === below?.id) element("path", { class: "below", d: outline([room.outline]) }, svg);
  const led = draft.stairs.filter((one) => one.level === below?.id);
  const built = at.walls, rooms = on("rooms"), name = built ? "sketch" : "sketch plot";
  if (built) for (const room of rooms) element("path", { class: name, d: outline([shifted(room, shift)]), "stroke-width": 2 * draft.outer_wall_thickness - (isInner(draft) ? 0 : draft.wall_thickness) }, svg);
  for (const room of rooms) {
    element("path", { class: room.id === picked ? `${name} on` : name, d: outline([shifted(room, shift)]), "stroke-width": !built ? 3 * px : isInner(draft) ? HAIR * px : draft.wall_thickness, "data-id": room.id }, svg);
  }
  for (const one of draft.streets) element("path", { class: one.id === picked ? "street on" : "street", d: line(shifted(one, shift)), "stroke-width": one.width, "data-id": one.id }, svg);
  for (const one of on("buildings")) element("path", { class: one.id === picked ? "building on" : "building", d: outline([shifted(one, shift)]), "stroke-width": HAIR * px, "data-id": one.id }, svg);
  for (const zone of on("zones")) element("path", { class: zone.id === picked ? "zone on" : "zone", d: outline([shifted(zone, shift)]), "data-id": zone.id }, svg);
  for (const one of on("columns")) {
    const half = one.size / 2, [x, y] = one.at;
    element("rect", { class: one.id === picked ? "ghost" : "wall", x: x - half, y: -y - half, width: one.size, height: one.size, "data-id": one.id }, svg);
  }
  if (!shift) for (const one of on("openings")) drawOpening(one, at, rooms, svg);
  for (const one of [...led, ...on("stairs")]) drawStairs(one, picked, svg, led.includes(one));
  const told = new Set();
  for (const row of [...rooms, ...on("zones"), ...draft.streets, ...on("buildings").filter((one) => one.id === picked)]) drawWords(row, at, told, svg);
  for (const fault of at.faults) if (!fault.warns && (!fault.level || fault.level === at.level)) drawFault(fault, svg, px);
  const row = [...rooms, ...on("zones"), ...on("buildings"), ...draft.streets].find((one) => one.id === picked);
  if (row && at.tool === "select") for (const [x, y] of shifted(row, shift)) element("circle", { class: "hold", cx: x, cy: -y, r: 5 * px }, svg);
  drawGhost(at, svg);
}

function drawGrid(svg, [x, y, width, height], px) {
  const step = [1, 5, 10, 50, 100].find((one) => one / px > 25) ?? 500;
  const lines = (from, until) => { const found = []; for (let at = Math.ceil(from / step) * step; at < until; at += step) found.push(at); return found; };
  for (const at of lines(x - 2 * width, x + 3 * width)) element("line", { class: "grid", x1: at, x2: at, y1: y - height, y2: y + 2 * height }, svg);
  for (const at of lines(y - 2 * height, y + 3 * height)) element("line", { class: "grid", y1: at, y2: at, x1: x - width, x2: x + 2 * width }, svg);
}

function drawOpening(one, { draft, picked }, rooms, svg) {
  const wall = nearestSide(rooms, one.at), thick = draft.wall_thickness, half = one.width / 2;
  if (!wall.row) return;
  const long = far(wall.a, wall.b) || 1, u = [(wall.b[0] - wall.a[0]) / long, (wall.b[1] - wall.a[1]) / long], [x, y] = one.at;
  const a = [x - u[0] * half, y - u[1] * half], b = [x + u[0] * half, y + u[1] * half], group = element("g", { "data-id": one.id }, svg);
  const outer = rooms.filter((room) => sides(room).some(([p, q]) => Math.abs(far(p, one.at) + far(one.at, q) - far(p, q)) < 1e-4)).length < 2;
  element("path", { class: "gap-line", d: line([a, b]), "stroke-width": outer ? 2 * draft.outer_wall_thickness - thick + 0.02 : thick * 1.15 }, group);
  const names = one.id === picked ? "leaf opening-on" : "leaf";
  if (one.kind === "window") for (const side of [-1, 0, 1]) {
    const n = [-u[1] * side * thick / 2.2, u[0] * side * thick / 2.2];
    element("path", { class: names, d: line([[a[0] + n[0], a[1] + n[1]], [b[0] + n[0], b[1] + n[1]]]) }, group);
  } else if (one.kind === "passage" || one.swing === "slide") {
    element("path", { class: names, d: line([a, b]), "stroke-dasharray": one.kind === "passage" ? "4 4" : "" }, group);
  } else {
    // Outlines run counter-clockwise, so the room lies to the left; left hinges are seen facing the door.
    const inward = one.swing === "in" ? 1 : -1, at = one.hinge === "left" ? b : a, end = one.hinge === "left" ? a : b;
    const tip = [at[0] - u[1] * inward * one.width, at[1] + u[0] * inward * one.width];
    const turn = (tip[0] - at[0]) * (end[1] - at[1]) - (tip[1] - at[1]) * (end[0] - at[0]) > 0 ? 0 : 1;
    element("path", { class: names, d: `${line([at, tip])} A${one.width} ${one.width} 0 0 ${turn} ${end[0]},${-end[1]}` }, group);
  }
  element("path", { d: line([a, b]), stroke: "transparent", "stroke-width": 0.4 }, group);
}

// The lowest steps and the way up; how far they reach follows from the storeys' heights.
function drawStairs({ id, at: [x, y], heading, width }, picked, svg, led = false) {
  const [c, s] = [Math.cos(heading), Math.sin(heading)], half = width / 2, place = (along, aside) => [x + c * along - s * aside, y + s * along + c * aside];
  const group = element("g", led ? { class: "stairs led" } : { "data-id": id, class: id === picked ? "stairs on" : "stairs" }, svg);
  element("path", { class: "tread", d: line([place(0, -half), place(0, half), place(2, half), place(2, -half)]) + "Z" }, group);
  for (let k = 1; k < 8; k += 1) element("path", { class: "leaf", d: line([place(k * 0.25, -half), place(k * 0.25, half)]) }, group);
  element("path", { class: "leaf", d: line([place(0.1, 0), place(1.85, 0)]) + line([place(1.6, 0.2), place(1.85, 0), place(1.6, -0.2)]) }, group);
}

function drawWords(row, { draft, shift, px, picked, faults, walls }, told, svg) {
  const ring = shifted(row, shift), size = 13 * px, zoned = draft.zones.length > 0 && !draft.zones.includes(row);
  if (row.outline) {
    const { area, at: [x, centre] } = middle(ring), y = zoned ? Math.max(...ring.map((p) => p[1])) + 2.4 * size : centre;
    if (!draft.buildings.includes(row)) element("text", { class: "title", x, y: -y, "font-size": size * 1.1 }, svg, row.name);
    element("text", { class: "area", x, y: -y + size * 1.3, "font-size": size }, svg, `${area.toFixed(area < 1000 ? 1 : 0)} m²`);
    const lacks = faults.some((fault) => fault.warns && fault.ids.includes(row.id));
    if (lacks) element("text", { class: "area bad-text", x, y: -y + size * 2.6, "font-size": size * 0.9 }, svg, t("no door yet"));
  }
  const wall = walls ? draft.wall_thickness / 2 : row.line ? row.width / 2 : 0;
  for (const [a, b, k] of sides({ ...row, [row.line ? "line" : "outline"]: ring })) {
    const long = far(a, b), u = [(b[0] - a[0]) / long, (b[1] - a[1]) / long], off = 14 * px + wall, both = [a, b].map(String).sort().join(" ");
    if (long < 60 * px || draft.zones.length && told.has(both) || row.outline && row.id !== picked && depthOf(ring, a, u) < (Math.abs(u[1]) > Math.abs(u[0]) ? 50 + 8 * row.name.length : 75) * px) continue;
    told.add(both);
    const mx = (a[0] + b[0]) / 2 - u[1] * off, my = (a[1] + b[1]) / 2 + u[0] * off;
    let turn = -Math.atan2(u[1], u[0]) * 180 / Math.PI;
    if (turn > 90.1 || turn <= -90.1) turn += 180;
    const made = element("text", { class: row.id === picked ? "length on" : "length", "font-size": size * 0.9, transform: `translate(${mx} ${-my}) rotate(${turn})`,
      "data-row": row.id, "data-edge": k }, svg, long.toFixed(2));
    made.dataset.long = long;
  }
}

// How far an outline reaches from one of its sides: a length in a narrow one would lie on its name.
const depthOf = (ring, a, u) => Math.max(...ring.map((p) => Math.abs((p[1] - a[1]) * u[0] - (p[0] - a[0]) * u[1])));

function drawFault(fault, svg, px) {
  if (fault.points.length > 2) element("path", { class: "wrong", d: outline([fault.points]) }, svg);
  else for (const [x, y] of fault.points) element("circle", { class: "wrong", cx: x, cy: -y, r: 14 * px }, svg);
}

export const rectangle = (a, b) => [[a[0], a[1]], [b[0], a[1]], [b[0], b[1]], [a[0], b[1]]];

function drawGhost({ press, here, poly, digits, guides, tool, px }, svg) {
  for (const pair of guides) element("path", { class: "guide", d: line(pair) }, svg);
  const label = (at, text) => element("text", { class: "title", x: at[0], y: -at[1] - 10 * px, "font-size": 14 * px }, svg, digits ? `${digits}▏` : text);
  if (press?.rectangle && here) {
    element("path", { class: "ghost", d: outline([rectangle(press.from, here)]) }, svg);
    label([(press.from[0] + here[0]) / 2, (press.from[1] + here[1]) / 2], `${Math.abs(here[0] - press.from[0]).toFixed(2)} × ${Math.abs(here[1] - press.from[1]).toFixed(2)}`);
  } else if (press?.stairs && here) {
    drawStairs({ id: "", at: press.from, heading: Math.atan2(here[1] - press.from[1], here[0] - press.from[0]), width: 0.9 }, "", svg);
  } else if (poly.length && here) {
    element("path", { class: "ghost", d: line([...poly, here]), fill: "none" }, svg);
    label(here, far(poly.at(-1), here).toFixed(2));
    for (const [x, y] of poly) element("circle", { class: "hold", cx: x, cy: -y, r: 4 * px }, svg);
  } else if (here?.wall?.far < 0.6 && ["door", "passage", "window"].includes(tool)) {
    element("circle", { class: "ghost", cx: here.wall.at[0], cy: -here.wall.at[1], r: 0.25 }, svg);
  }
}
