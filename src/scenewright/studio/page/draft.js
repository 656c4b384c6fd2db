// Drawing a plan: rooms by the middle lines of their walls, openings, columns. What is shown is the
// server's drawing; every act is sent to it. Typed digits are lengths.
import { element, line, outline } from "/draw.js";
import { t } from "/words.js";
import { $, fill, make, say } from "/wire.js";

const SNAPS = ["grid", "lines", "angles", "off"], GRID = 0.1, NEAR = 9, ANGLE = Math.PI / 12, LEAST = 0.3;
const SNAP_WORDS = [t("grid and lines"), t("lines"), t("angles"), t("off")];
const TOOLS = { v: "select", r: "room", d: "door", p: "passage", w: "window", c: "column" };
const HINTS = { select: t("Drag a corner or a wall; click a length to type it; Delete removes"),
  room: t("Drag a rectangle, or click corner after corner and the first again; digits type a length (4.2 or 4.2x3.6), Enter"),
  door: t("Click a wall"), passage: t("Click a wall: an open passage"), window: t("Click a wall"), column: t("Click a floor"), scale: t("Drag along a length you know in the image, then type it in metres") };
let draft = null, faults = [], act = null, tool = "room", snapping = 0, picked = "", view = [-1.5, -9, 14, 10.5];
let under = null;
let poly = [], press = null, here = null, digits = "", guides = [], shift = null, after = null;

export function showDrawing(doc, change) {
  act = async (keys) => { const said = await change("draw", keys); if (!said.fault) after?.(); after = null; return said; };
  for (const id of ["drawing", "drawn"]) $(id).hidden = false;
  $("facts").hidden = true; $("draw").ariaPressed = true;
  if (doc.draft?.rooms.length) { tool = "select"; fit(doc.draft); } else { tool = "room"; view = [-1.5, -9, 14, 10.5]; }
  refreshDrawing(doc);
  $("draft").focus();
}

export function hideDrawing() {
  for (const id of ["drawing", "drawn", "typed"]) $(id).hidden = true;
  $("facts").hidden = false; $("draw").ariaPressed = false;
}

export function refreshDrawing(doc) {
  if ($("drawing").hidden || !doc.draft) return;
  draft = doc.draft; faults = doc.faults ?? [];
  show();
}

function fit(one) {
  const points = one.rooms.flatMap((room) => room.outline), xs = points.map((p) => p[0]), ys = points.map((p) => -p[1]);
  const [x, y] = [Math.min(...xs) - 1.5, Math.min(...ys) - 1.5];
  view = [x, y, Math.max(...xs) + 1.5 - x, Math.max(...ys) + 1.5 - y];
}

const scale = () => { const box = $("draft").getBoundingClientRect(); return Math.max(view[2] / box.width, view[3] / box.height); };
const point = (event) => { const at = new DOMPoint(event.clientX, event.clientY).matrixTransform($("draft").getScreenCTM().inverse()); return [at.x, -at.y]; };
const far = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
const to = (value, step) => Math.round(value / step) * step;
const edges = (room) => room.outline.map((a, k) => [a, room.outline[(k + 1) % room.outline.length], k]);

// Snapping: corners first, then lines through them, then the grid; angles from the last corner.
function snap(raw, event, from = null) {
  guides = [];
  if (event?.altKey || SNAPS[snapping] === "off") return raw.map((value) => to(value, 0.01));
  const tolerance = NEAR * scale(), corners = [...draft.rooms.flatMap((room) => room.outline), ...poly];
  const corner = corners.find((one) => far(one, raw) < tolerance);
  if (corner) return [...corner];
  if (SNAPS[snapping] === "angles" && from) {
    const angle = to(Math.atan2(raw[1] - from[1], raw[0] - from[0]), ANGLE), long = to(far(raw, from), 0.05);
    guides.push([from, raw]);
    return [from[0] + long * Math.cos(angle), from[1] + long * Math.sin(angle)];
  }
  const rest = SNAPS[snapping] === "lines" ? 0.01 : GRID;
  return raw.map((value, axis) => {
    const near = corners.filter((one) => Math.abs(one[axis] - value) < tolerance).sort((a, b) => Math.abs(a[axis] - value) - Math.abs(b[axis] - value))[0];
    if (!near) return to(value, rest);
    guides.push([near, axis ? [raw[0], near[1]] : [near[0], raw[1]]]);
    return near[axis];
  });
}

function nearestWall(at) {
  let best = { far: Infinity };
  for (const room of draft.rooms) for (const [a, b, k] of edges(room)) {
    const along = [b[0] - a[0], b[1] - a[1]], long = along[0] ** 2 + along[1] ** 2 || 1e-9;
    const share = Math.min(1, Math.max(0, ((at[0] - a[0]) * along[0] + (at[1] - a[1]) * along[1]) / long));
    const foot = [a[0] + share * along[0], a[1] + share * along[1]];
    if (far(foot, at) < best.far) best = { far: far(foot, at), room, k, a, b, at: foot };
  }
  return best;
}

function onWall(at, event) {
  const wall = nearestWall(at), long = far(wall.a ?? [0, 0], wall.b ?? [0, 0]);
  if (wall.far > 0.6 || event?.altKey || SNAPS[snapping] === "off") return wall;
  const part = far(wall.a, wall.at), middle = Math.abs(part - long / 2) < 0.12, share = (middle ? long / 2 : to(part, GRID)) / long;
  return { ...wall, at: [wall.a[0] + share * (wall.b[0] - wall.a[0]), wall.a[1] + share * (wall.b[1] - wall.a[1])] };
}

// What the server does with a moved corner or wall, shown while it is dragged.
const liesOn = (at, points) => points.some((one) => far(one, at) < 1e-6)
  || points.length === 2 && Math.abs(far(points[0], at) + far(at, points[1]) - far(...points)) < 1e-6;
const shifted = (room) => shift ? room.outline.map((at) => liesOn(at, shift.points) ? [at[0] + shift.by[0], at[1] + shift.by[1]] : at) : room.outline;

// A wall with the walls in one line with it that it is joined to, as the server moves them.
function prolong(a, b) {
  const long = far(a, b), u = [(b[0] - a[0]) / long, (b[1] - a[1]) / long];
  const off = (p) => Math.abs((p[1] - a[1]) * u[0] - (p[0] - a[0]) * u[1]), part = (p) => (p[0] - a[0]) * u[0] + (p[1] - a[1]) * u[1];
  const spans = draft.rooms.flatMap(edges).filter(([p, q]) => off(p) < 1e-6 && off(q) < 1e-6).map(([p, q]) => [part(p), part(q)].sort((x, y) => x - y));
  let low = 0, high = long;
  for (const _ of spans) for (const [from, until] of spans) if (from <= high + 1e-6 && until >= low - 1e-6) { low = Math.min(low, from); high = Math.max(high, until); }
  return [low, high].map((at) => [a[0] + u[0] * at, a[1] + u[1] * at]);
}

const isOuter = (at) => draft.rooms.filter((room) => edges(room).some(([a, b]) => Math.abs(far(a, at) + far(at, b) - far(a, b)) < 1e-4)).length < 2;

function show() {
  const svg = $("draft"), px = scale();
  svg.setAttribute("viewBox", view.join(" ")); svg.dataset.tool = tool;
  svg.replaceChildren();
  if (under) element("image", { href: under.href, x: 0, y: -under.width * under.tall, width: under.width, height: under.width * under.tall, opacity: 0.55 }, svg);
  drawGrid(svg, px);
  const outer = 2 * draft.outer_wall_thickness - draft.wall_thickness;
  for (const room of draft.rooms) element("path", { class: "sketch", d: outline([shifted(room)]), "stroke-width": outer }, svg);
  for (const room of draft.rooms) {
    const ring = shifted(room);
    element("path", { class: room.id === picked ? "sketch on" : "sketch", d: outline([ring]), "stroke-width": draft.wall_thickness, "data-id": room.id }, svg);
  }
  for (const one of draft.columns) {
    const half = one.size / 2, [x, y] = one.at;
    element("rect", { class: one.id === picked ? "ghost" : "wall", x: x - half, y: -y - half, width: one.size, height: one.size, "data-id": one.id }, svg);
  }
  if (!shift) for (const one of draft.openings) drawOpening(one, svg);
  for (const room of draft.rooms) drawWords(room, shifted(room), svg, px);
  for (const fault of faults) drawFault(fault, svg, px);
  const room = draft.rooms.find((one) => one.id === picked);
  if (room && tool === "select") for (const [x, y] of shifted(room)) element("circle", { class: "hold", cx: x, cy: -y, r: 5 * px }, svg);
  drawGhost(svg, px);
  for (const button of $("tools").querySelectorAll("[data-tool]")) button.ariaPressed = button.dataset.tool === tool;
  $("snap").replaceChildren(t("Snap: {how} ", { how: SNAP_WORDS[snapping] }), make("kbd", { textContent: "S" }));
  $("hint").textContent = HINTS[tool];
  $("furnish").disabled = !draft.rooms.length || faults.some((fault) => !fault.warns);
  showPanel();
}

function drawGrid(svg, px) {
  const step = px > 0.04 ? 5 : 1, [x, y, width, height] = view, reach = 2;
  for (let at = Math.floor(x - width * reach); at < x + width * (1 + reach); at += 1) if (at % step === 0) element("line", { class: "grid", x1: at, x2: at, y1: y - height, y2: y + 2 * height }, svg);
  for (let at = Math.floor(y - height * reach); at < y + height * (1 + reach); at += 1) if (at % step === 0) element("line", { class: "grid", y1: at, y2: at, x1: x - width, x2: x + 2 * width }, svg);
}

function drawOpening(one, svg) {
  const wall = nearestWall(one.at), thick = draft.wall_thickness, half = one.width / 2;
  if (!wall.room) return;
  const long = far(wall.a, wall.b) || 1, u = [(wall.b[0] - wall.a[0]) / long, (wall.b[1] - wall.a[1]) / long], [x, y] = one.at;
  const a = [x - u[0] * half, y - u[1] * half], b = [x + u[0] * half, y + u[1] * half], group = element("g", { "data-id": one.id }, svg);
  element("path", { class: "gap-line", d: line([a, b]), "stroke-width": isOuter(one.at) ? 2 * draft.outer_wall_thickness - thick + 0.02 : thick * 1.15 }, group);
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

function middle(ring) {
  let area = 0, x = 0, y = 0;
  ring.forEach(([ax, ay], k) => {
    const [bx, by] = ring[(k + 1) % ring.length], cross = ax * by - bx * ay;
    area += cross / 2; x += (ax + bx) * cross / 6; y += (ay + by) * cross / 6;
  });
  return { area, at: Math.abs(area) < 1e-9 ? ring[0] : [x / area, y / area] };
}

function drawWords(room, ring, svg, px) {
  const { area, at: [x, y] } = middle(ring), size = 13 * px;
  element("text", { class: "title", x, y: -y, "font-size": size * 1.1 }, svg, room.name);
  element("text", { class: "area", x, y: -y + size * 1.3, "font-size": size }, svg, `${area.toFixed(1)} m²`);
  const lacks = faults.some((fault) => fault.warns && fault.ids.includes(room.id));
  if (lacks) element("text", { class: "area bad-text", x, y: -y + size * 2.6, "font-size": size * 0.9 }, svg, t("no door yet"));
  edges({ outline: ring }).forEach(([a, b, k]) => {
    const long = far(a, b), u = [(b[0] - a[0]) / long, (b[1] - a[1]) / long], off = 14 * px + draft.wall_thickness / 2;
    if (long < 60 * px) return;
    const mx = (a[0] + b[0]) / 2 - u[1] * off, my = (a[1] + b[1]) / 2 + u[0] * off;
    let turn = -Math.atan2(u[1], u[0]) * 180 / Math.PI;
    if (turn > 90.1 || turn <= -90.1) turn += 180;
    const made = element("text", { class: room.id === picked ? "length on" : "length", "font-size": size * 0.9, transform: `translate(${mx} ${-my}) rotate(${turn})`,
      "data-room": room.id, "data-edge": k }, svg, long.toFixed(2));
    made.dataset.long = long;
  });
}

function drawFault(fault, svg, px) {
  if (fault.warns) return;
  const kind = "wrong";
  if (fault.points.length > 2) element("path", { class: kind, d: outline([fault.points]) }, svg);
  else for (const [x, y] of fault.points) element("circle", { class: kind, cx: x, cy: -y, r: 14 * px }, svg);
}

function drawGhost(svg, px) {
  for (const pair of guides) element("path", { class: "guide", d: line(pair) }, svg);
  const label = (at, text) => element("text", { class: "title", x: at[0], y: -at[1] - 10 * px, "font-size": 14 * px }, svg, digits ? `${digits}▏` : text);
  if (press?.rectangle && here) {
    element("path", { class: "ghost", d: outline([rectangle(press.from, here)]) }, svg);
    label([(press.from[0] + here[0]) / 2, (press.from[1] + here[1]) / 2], `${Math.abs(here[0] - press.from[0]).toFixed(2)} × ${Math.abs(here[1] - press.from[1]).toFixed(2)}`);
  } else if (poly.length && here) {
    element("path", { class: "ghost", d: line([...poly, here]), fill: "none" }, svg);
    label(here, far(poly.at(-1), here).toFixed(2));
    for (const [x, y] of poly) element("circle", { class: "hold", cx: x, cy: -y, r: 4 * px }, svg);
  } else if (here && ["door", "passage", "window"].includes(tool)) {
    const wall = here.wall;
    if (wall?.far < 0.6) element("circle", { class: "ghost", cx: wall.at[0], cy: -wall.at[1], r: 0.25 }, svg);
  }
}

const rectangle = (a, b) => [[a[0], a[1]], [b[0], a[1]], [b[0], b[1]], [a[0], b[1]]];

function showPanel() {
  const room = draft.rooms.find((one) => one.id === picked), opening = draft.openings.find((one) => one.id === picked);
  const column = draft.columns.find((one) => one.id === picked);
  $("of-room").hidden = !room; $("of-opening").hidden = !opening; $("of-plan").hidden = Boolean(room || opening || column); $("erase").hidden = !(room || opening || column);
  const put = (id, value) => { if (document.activeElement !== $(id)) $(id).value = value; };
  if (room) { put("room-name", room.name); $("room-area").textContent = t("{area} m² between the middles of its walls", { area: middle(room.outline).area.toFixed(2) }); }
  if (opening) {
    $("opening-kind").textContent = { door: t("Door"), passage: t("Passage"), window: t("Window") }[opening.kind]; put("opening-width", opening.width);
    $("of-sill").hidden = opening.kind !== "window"; $("of-leaf").hidden = opening.kind !== "door";
    put("opening-sill", opening.sill ?? ""); put("opening-swing", opening.swing ?? "in"); put("opening-hinge", opening.hinge ?? "left");
  }
  put("plan-name", draft.name); put("wall", draft.wall_thickness); put("outer-wall", draft.outer_wall_thickness);
  fill("faults", faults, (fault) => {
    const button = make("button", { textContent: fault.message, onclick: () => {
      picked = fault.ids[0] ?? "";
      if (fault.points.length) { const [x, y] = fault.points[0]; view = [x - view[2] / 2, -y - view[3] / 2, view[2], view[3]]; }
      show();
    } });
    return make("li", { className: fault.warns ? "" : "bad" }, button);
  });
  if (!faults.length && draft.rooms.length) $("faults").replaceChildren(make("li", { textContent: t("nothing") }));
}

function choose(name) { tool = name; poly = []; press = null; digits = ""; guides = []; show(); }

async function finish(ring) {
  poly = []; press = null; digits = ""; guides = []; here = null;
  after = () => { picked = draft.rooms.at(-1)?.id ?? ""; show(); $("room-name").focus(); $("room-name").select(); };
  await act({ act: "room", outline: ring });
}

$("draft").addEventListener("pointerdown", (event) => {
  const raw = point(event), label = event.target.closest?.("[data-edge]");
  $("typed").hidden = true;
  if (event.button === 1) { press = pan(event); return; }
  if (tool === "select" && label) { type(label); return; }
  $("draft").setPointerCapture(event.pointerId);
  if (tool === "scale") { poly = [raw]; here = raw; press = { scale: true }; show(); return; }
  if (tool === "room") {
    const at = snap(raw, event, poly.at(-1));
    if (!poly.length) { press = { rectangle: true, from: at }; here = at; }
    else if (poly.length > 2 && far(at, poly[0]) < NEAR * scale()) { finish(poly); return; } else poly.push(at);
  } else if (tool === "select") press = grasp(event, raw);
  else {
    const wall = onWall(raw, event), keys = tool === "column" ? { act: "column", at: snap(raw, event) } : { act: "opening", kind: tool, at: wall.at };
    if (tool !== "column" && !(wall.far < 0.6)) { say(t("choose a place on a wall")); return; }
    after = () => { picked = (tool === "column" ? draft.columns : draft.openings).at(-1)?.id ?? ""; show(); };
    act(keys);
  }
  show();
});

const pan = (event) => ({ pan: true, from: [event.clientX, event.clientY], start: [...view] });

function grasp(event, raw) {
  const near = NEAR * scale(), own = event.target.closest?.("[data-id]")?.dataset.id ?? "";
  if (draft.openings.some((one) => one.id === own) || draft.columns.some((one) => one.id === own)) { picked = own; return { thing: own, from: raw }; }
  const corner = draft.rooms.flatMap((room) => room.outline).find((one) => far(one, raw) < near);
  if (corner) return { points: [corner], from: corner };
  const wall = nearestWall(raw);
  if (wall.far < near) { picked = picked && draft.rooms.some((one) => one.id === picked) ? picked : wall.room.id; return { points: prolong(wall.a, wall.b), from: wall.at, wall }; }
  picked = draft.rooms.some((one) => one.id === own) ? own : "";
  return pan(event);
}

$("draft").addEventListener("pointermove", (event) => {
  const raw = point(event);
  if (press?.pan) {
    const by = scale();
    view = [press.start[0] - (event.clientX - press.from[0]) * by, press.start[1] - (event.clientY - press.from[1]) * by, view[2], view[3]];
  } else if (press?.scale) {
    here = raw;
  } else if (press?.points) {
    const at = snap(raw, event, press.from), by = [at[0] - press.from[0], at[1] - press.from[1]];
    if (press.wall) {
      const { a, b } = press.wall, long = far(a, b), n = [-(b[1] - a[1]) / long, (b[0] - a[0]) / long], out = by[0] * n[0] + by[1] * n[1];
      by[0] = n[0] * out; by[1] = n[1] * out;
    }
    shift = { points: press.points, by };
  } else if (press?.thing) {
    const one = [...draft.openings, ...draft.columns].find((row) => row.id === press.thing);
    one.at = draft.columns.includes(one) ? snap(raw, event) : onWall(raw, event).at ?? one.at;
    press.moved = true;
  } else if (tool === "room") here = snap(raw, event, press?.from ?? poly.at(-1));
  else if (tool !== "select" && tool !== "column") { here = raw; here.wall = onWall(raw, event); }
  else return;
  show();
});

$("draft").addEventListener("pointerup", async (event) => {
  const done = press; press = null; guides = [];
  if (done?.scale) {
    const long = far(poly[0], here), from = poly[0], to_ = here;
    poly = []; here = null; show();
    if (under && long > 0.05) typeScale(from, to_, long);
    return;
  }
  if (done?.rectangle) {
    if (Math.min(Math.abs(here[0] - done.from[0]), Math.abs(here[1] - done.from[1])) > LEAST) await finish(rectangle(done.from, here));
    else { poly = [done.from]; show(); }
  } else if (done?.points && shift) {
    const asked = shift; shift = null;
    if (Math.hypot(...asked.by) > 0.005) await act({ act: "move", points: asked.points, by: asked.by }); else show();
  } else if (done?.thing && done.moved) {
    const one = [...draft.openings, ...draft.columns].find((row) => row.id === done.thing);
    await act({ act: "set", id: done.thing, key: "at", value: one.at });
  }
});

$("draft").addEventListener("wheel", (event) => {
  event.preventDefault();
  const [x, y] = point(event), by = Math.exp(event.deltaY * 0.0012);
  view = [x + (view[0] - x) * by, -y + (view[1] + y) * by, view[2] * by, view[3] * by];
  show();
}, { passive: false });

// The image gets the scale at which a line drawn over it has the length typed.
function typeScale(from, until, long) {
  const input = $("typed"), frame = $("drawing").getBoundingClientRect(), matrix = $("draft").getScreenCTM();
  const at = new DOMPoint((from[0] + until[0]) / 2, -(from[1] + until[1]) / 2).matrixTransform(matrix);
  Object.assign(input.style, { left: `${at.x - frame.x}px`, top: `${at.y - frame.y}px` });
  input.value = ""; input.hidden = false;
  input.onkeydown = (event) => {
    if (event.key === "Escape") input.hidden = true;
    if (event.key !== "Enter") return;
    const metres = Number(input.value.replace(",", "."));
    input.hidden = true;
    if (metres > 0) { under.width *= metres / long; choose("room"); }
  };
  setTimeout(() => input.focus());
}

$("under").onchange = async (event) => {
  const file = event.target.files[0];
  if (!file) return;
  const href = URL.createObjectURL(file), image = new Image();
  image.src = href; await image.decode().catch(() => say(t("this is no image")));
  if (!image.width) return;
  under = { href, width: 12, tall: image.height / image.width };
  view = [-1, -under.width * under.tall - 1, under.width + 2, under.width * under.tall + 2];
  $("scale").hidden = false; choose("scale");
};

function type(label) {
  const input = $("typed"), box = label.getBoundingClientRect(), frame = $("drawing").getBoundingClientRect();
  picked = label.dataset.room; show();
  Object.assign(input.style, { left: `${box.x + box.width / 2 - frame.x}px`, top: `${box.y + box.height / 2 - frame.y}px` });
  input.value = Number(label.dataset.long).toFixed(2); input.hidden = false;
  input.onkeydown = async (event) => {
    if (event.key === "Escape") input.hidden = true;
    if (event.key !== "Enter") return;
    input.hidden = true;
    await act({ act: "length", id: label.dataset.room, edge: Number(label.dataset.edge), metres: Number(input.value.replace(",", ".")) });
  };
  setTimeout(() => { input.focus(); input.select(); });
}

// Digits while a room is drawn: a length along the pointer's direction, or two of a rectangle.
function commitDigits() {
  const [width, depth] = digits.replaceAll(",", ".").split("x").map(Number), from = press?.from ?? poly.at(-1);
  digits = "";
  if (!from || !here || !(width > 0)) return;
  const sign = (axis) => here[axis] < from[axis] ? -1 : 1;
  if (depth > 0) { finish(rectangle(from, [from[0] + sign(0) * width, from[1] + sign(1) * depth])); return; }
  const long = far(from, here) || 1;
  poly = [...(poly.length ? poly : [from]), [from[0] + (here[0] - from[0]) / long * width, from[1] + (here[1] - from[1]) / long * width]];
  press = null; show();
}

document.addEventListener("keydown", (event) => {
  if ($("drawing").hidden || event.target.matches("input, select")) return;
  const key = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) return;
  if ((poly.length || press?.rectangle) && /^[0-9.,x]$/.test(key)) { digits += key; show(); }
  else if (key === "backspace" && digits) { digits = digits.slice(0, -1); show(); }
  else if (key === "enter" && digits) commitDigits();
  else if (key === "enter" && poly.length > 2) finish(poly);
  else if (key === "escape") { picked = ""; choose(poly.length || press ? tool : "select"); }
  else if (key === "s") { snapping = (snapping + 1) % SNAPS.length; show(); }
  else if (["delete", "backspace"].includes(key) && picked) $("erase").click();
  else if (TOOLS[key]) choose(TOOLS[key]);
  else return;
  event.preventDefault();
});

for (const button of $("tools").querySelectorAll("[data-tool]")) button.onclick = () => choose(button.dataset.tool);
$("snap").onclick = () => { snapping = (snapping + 1) % SNAPS.length; show(); };
$("erase").onclick = () => { const id = picked; picked = ""; act({ act: "remove", id }); };
const set = (id, key, own, number = false) => {
  $(id).onchange = () => act({ act: "set", ...(own ? { id: picked } : {}), key, value: number ? Number($(id).value) : $(id).value });
};
set("room-name", "name", true); set("opening-width", "width", true, true); set("opening-sill", "sill", true, true);
set("opening-swing", "swing", true); set("opening-hinge", "hinge", true);
set("plan-name", "name", false); set("wall", "wall_thickness", false, true); set("outer-wall", "outer_wall_thickness", false, true);
$("room-name").onkeydown = (event) => { if (event.key === "Enter") { $("room-name").blur(); $("draft").focus(); } };
