// Drawing a plan: homes and halls by the middle lines of their walls, sites and villages by their
// borders and streets. What is shown is the server's drawing; every act is sent to it. Typed digits
// are lengths.
import { isInner, rectangle, drawSketch } from "/sketch.js";
import { far, middle, nearestSide, onWall, pointsOf, prolong, SNAPS, sides, snap } from "/snapping.js";
import { t } from "/words.js";
import { $, fill, make, say } from "/wire.js";
import { showWishes } from "/wishes.js";

const NEAR = 9, SNAP_WORDS = [t("grid"), t("lines"), t("angles"), t("off")];
const TOOLS = { v: "select", r: "room", z: "zone", t: "street", f: "path", d: "door", p: "passage", w: "window", c: "column", u: "stairs", b: "building" };
const OUTLINES = t("Drag a rectangle, or click corner after corner and the first again; digits type a length (4.2 or 4.2x3.6), Enter");
const LINES = t("Click along its middle; digits type a length; Enter, or a click on the last point, ends it");
const HINTS = { select: t("Drag a corner or a wall; click a length to type it; Delete removes"), room: OUTLINES, zone: OUTLINES, building: OUTLINES, street: LINES, path: LINES, stairs: t("Drag from the lowest step the way they lead up"),
  door: t("Click a wall"), passage: t("Click a wall: an open passage"), window: t("Click a wall"), column: t("Click a floor"), scale: t("Drag along a length you know in the image, then type it in metres") };
// What is drawn in each kind of scene, the grid in metres, and how much is seen at first.
const KINDS = {
  home: { tools: ["room", "door", "passage", "window", "column", "stairs"], noun: t("Room"), grid: 0.1, view: [-1.5, -9, 14, 10.5] },
  hall: { tools: ["room", "zone", "door", "passage", "window", "column"], noun: t("Hall"), grid: 0.1, view: [-3, -20, 36, 24] },
  site: { tools: ["room", "street", "path"], noun: t("Site"), grid: 1, view: [-20, -120, 190, 140] },
  village: { tools: ["room", "street", "path"], noun: t("Block"), grid: 1, view: [-20, -90, 150, 110] },
  extend: { tools: ["building", "street", "path", "room"], noun: t("Area"), grid: 0.5, view: [-20, -90, 150, 110] },
};
const at = { draft: null, faults: [], walls: true, storeys: true, level: "", tool: "room", picked: "", view: KINDS.home.view, px: 0.01, under: null, poly: [], press: null, here: null, digits: "", guides: [], shift: null };
let act = null, snapping = 0, after = null, known = "";

const kind = () => KINDS[at.draft.domain];
const here = (group) => at.draft[group].filter((one) => one.level === at.level);
const outlines = () => [...here("rooms"), ...here("zones"), ...here("buildings")];
const find = (id) => ["rooms", "zones", "buildings", "streets", "stairs", "openings", "columns"].flatMap((group) => at.draft[group].filter((one) => one.id === id).map((row) => [group, row]))[0] ?? ["", null];

export function showDrawing(doc, change) {
  act = async (keys) => { const said = await change("draw", { level: at.level, ...keys }); if (!said.fault) after?.(); after = null; return said; };
  for (const id of ["drawing", "drawn"]) $(id).hidden = false;
  $("facts").hidden = true; $("draw").ariaPressed = true; $("drawn").append($("wishing"));
  known = "";
  refreshDrawing(doc);
  $("draft").focus();
}

export function hideDrawing() {
  for (const id of ["drawing", "drawn", "typed"]) $(id).hidden = true;
  $("facts").hidden = false; $("draw").ariaPressed = false; $("adding").after($("wishing"));
}

export function refreshDrawing(doc) {
  if ($("drawing").hidden || !doc.draft) return;
  at.draft = doc.draft; at.faults = doc.faults ?? []; at.walls = doc.walls; at.storeys = doc.storeys;
  if (!at.draft.levels.some((one) => one.id === at.level)) at.level = at.draft.levels[0].id;
  const begun = `${at.draft.domain} ${at.draft.name}`;
  if (begun !== known && (!known || !at.draft.rooms.length)) { at.tool = at.draft.rooms.length ? "select" : kind().tools[0]; frame(); }
  known = begun;
  show();
}

function frame() {
  const points = [...at.draft.rooms, ...at.draft.buildings, ...at.draft.streets].flatMap(pointsOf), edge = 15 * kind().grid;
  if (!points.length) { at.view = kind().view; return; }
  const xs = points.map((p) => p[0]), ys = points.map((p) => -p[1]), [x, y] = [Math.min(...xs) - edge, Math.min(...ys) - edge];
  at.view = [x, y, Math.max(...xs) + edge - x, Math.max(...ys) + edge - y];
}

const scale = () => { const box = $("draft").getBoundingClientRect(); return Math.max(at.view[2] / box.width, at.view[3] / box.height); };
const point = (event) => { const found = new DOMPoint(event.clientX, event.clientY).matrixTransform($("draft").getScreenCTM().inverse()); return [found.x, -found.y]; };
const how = (event) => event?.altKey ? "off" : SNAPS[snapping];

function caught(raw, event, from = null) {
  const under = at.draft.levels.findIndex((one) => one.id === at.level) - 1, below = at.draft.rooms.filter((one) => one.level === at.draft.levels[under]?.id);
  const corners = [...outlines(), ...at.draft.streets, ...below].flatMap(pointsOf).concat(at.poly);
  const found = snap(raw, { how: how(event), corners, tolerance: NEAR * scale(), grid: kind().grid, from });
  at.guides = found.guides;
  return found.at;
}

const wallAt = (raw, event) => onWall(here("rooms"), raw, { how: how(event), grid: kind().grid });

function show() {
  at.px = scale();
  $("draft").dataset.tool = at.tool;
  drawSketch($("draft"), at);
  for (const button of $("tools").querySelectorAll("[data-tool]")) {
    button.ariaPressed = button.dataset.tool === at.tool;
    button.hidden = button.dataset.tool === "scale" ? !at.under : !["select", ...kind().tools].includes(button.dataset.tool);
  }
  $("outline-noun").textContent = kind().noun;
  $("snap").replaceChildren(t("Snap: {how} ", { how: SNAP_WORDS[snapping] }), make("kbd", { textContent: "S" }));
  $("hint").textContent = HINTS[at.tool];
  $("furnish").disabled = !at.draft.rooms.length || at.faults.some((fault) => !fault.warns);
  showStoreys(); showPanel();
}

function showStoreys() {
  $("storeys").hidden = !at.storeys;
  const tabs = at.draft.levels.length < 2 ? [] : at.draft.levels.map((one, k) => make("button", { textContent: one.name || (k ? t("Floor {n}", { n: k }) : t("Ground floor")), role: "tab", ariaSelected: one.id === at.level,
    onclick: () => { at.level = one.id; at.picked = ""; choose("select"); } }));
  $("storey-tabs").replaceChildren(...tabs);
}

function showPanel() {
  const [group, row] = find(at.picked), of = { rooms: "of-room", zones: "of-room", buildings: "of-building", openings: "of-opening", streets: "of-street", stairs: "of-stairs", columns: "of-column" }[group] ?? (row ? "" : "of-plan");
  for (const id of ["of-room", "of-opening", "of-building", "of-street", "of-stairs", "of-column", "of-plan"]) $(id).hidden = id !== of;
  $("erase").hidden = !row; $("twin").hidden = !moves(group);
  const put = (id, value) => { if (document.activeElement !== $(id)) $(id).value = value; };
  if (of === "of-room") {
    $("outline-kind").textContent = group === "zones" ? t("Zone") : kind().noun; put("room-name", row.name);
    const { area } = middle(row.outline), built = at.walls && group === "rooms";
    $("room-area").textContent = isInner(at.draft) ? t("{area} m² between its walls", { area: area.toFixed(2) }) : built ? t("{area} m² between the middles of its walls", { area: area.toFixed(2) }) : t("{area} m²", { area: area.toFixed(area < 1000 ? 2 : 0) });
  }
  if (of === "of-opening") {
    $("opening-kind").textContent = { door: t("Door"), passage: t("Passage"), window: t("Window") }[row.kind]; put("opening-width", row.width);
    $("of-sill").hidden = row.kind !== "window"; $("of-leaf").hidden = row.kind !== "door";
    put("opening-sill", row.sill ?? ""); put("opening-swing", row.swing ?? "in"); put("opening-hinge", row.hinge ?? "left");
  }
  if (of === "of-building") { put("building-height", row.height); put("building-use", row.use); put("building-roof", row.roof); }
  if (of === "of-street") { put("street-name", row.name); put("street-width", row.width); put("street-kind", row.kind); }
  if (of === "of-column") put("column-size", row.size);
  if (of === "of-stairs") { put("stairs-width", row.width); put("stairs-shape", row.shape); put("stairs-turn", row.turn); put("stairs-heading", Math.round(row.heading * 180 / Math.PI)); }
  put("plan-name", at.draft.name); put("wall", at.draft.wall_thickness); put("outer-wall", at.draft.outer_wall_thickness); put("village-style", at.draft.style || "rural");
  const storey = at.draft.levels.find((one) => one.id === at.level);
  put("storey-name", storey.name); put("storey-height", storey.height);
  $("of-walls").hidden = !at.walls; $("of-style").hidden = at.draft.domain !== "village"; $("of-storey").hidden = !at.storeys || at.draft.levels.length < 2;
  listFaults();
  const place = group === "rooms" ? row : !row && at.draft.rooms.length === 1 ? at.draft.rooms[0] : null;
  showWishes(place, at.draft.domain, place && (place.asked ?? {}), (asked) => act({ act: "ask", id: place.id, asked }), { zones: at.draft.zones });
}

function listFaults() {
  fill("faults", at.faults, (fault) => make("li", { className: fault.warns ? "" : "bad" }, make("button", { textContent: fault.message, onclick: () => {
    at.picked = fault.ids[0] ?? ""; at.level = fault.level || at.level;
    if (fault.points.length) { const [x, y] = fault.points[0], [, , wide, tall] = at.view; at.view = [x - wide / 2, -y - tall / 2, wide, tall]; }
    show();
  } })));
  if (!at.faults.length && at.draft.rooms.length) $("faults").replaceChildren(make("li", { textContent: t("nothing") }));
}

function choose(name) { Object.assign(at, { tool: name, poly: [], press: null, digits: "", guides: [] }); show(); }
const pick = (group) => () => { at.picked = at.draft[group].at(-1)?.id ?? ""; show(); };
const moves = (group) => !at.walls && ["rooms", "buildings", "streets"].includes(group);
const isLine = () => ["street", "path"].includes(at.tool);

async function finish(points) {
  const line = isLine(), group = line ? "streets" : `${at.tool}s`, name = line ? "street-name" : "room-name";
  Object.assign(at, { poly: [], press: null, digits: "", guides: [], here: null });
  after = () => { pick(group)(); if (at.tool !== "building") { $(name).focus(); $(name).select(); } };
  await act(line ? { act: "street", line: points, kind: at.tool === "path" ? "path" : "road" } : { act: at.tool, outline: points });
}

$("draft").addEventListener("pointerdown", (event) => {
  const raw = point(event), label = event.target.closest?.("[data-edge]"), near = NEAR * scale(), { tool, poly } = at;
  $("typed").hidden = true;
  if (event.button === 1) { at.press = pan(event); return; }
  if (tool === "select" && label) { type(label); return; }
  $("draft").setPointerCapture(event.pointerId);
  if (tool === "scale") Object.assign(at, { poly: [raw], here: raw, press: { scale: true } });
  else if (["room", "zone", "building"].includes(tool)) {
    const spot = caught(raw, event, poly.at(-1));
    if (!poly.length) Object.assign(at, { press: { rectangle: true, from: spot }, here: spot });
    else if (poly.length > 2 && far(spot, poly[0]) < near) { finish(poly); return; } else poly.push(spot);
  } else if (isLine()) {
    if (poly.length > 1 && far(raw, poly.at(-1)) < near) { finish(poly); return; }
    const spot = caught(raw, event, poly.at(-1));
    poly.push(spot); at.here = spot;
  } else if (tool === "stairs") { const spot = caught(raw, event); Object.assign(at, { press: { stairs: true, from: spot }, here: [spot[0], spot[1] + 1] }); }
  else if (tool === "select") at.press = grasp(event, raw, near);
  else if (tool === "column") { after = pick("columns"); act({ act: "column", at: caught(raw, event) }); }
  else {
    const wall = wallAt(raw, event);
    if (!(wall.far < 0.6)) { say(t("choose a place on a wall")); return; }
    after = pick("openings"); act({ act: "opening", kind: tool, at: wall.at });
  }
  show();
});

const pan = (event) => ({ pan: true, from: [event.clientX, event.clientY], start: [...at.view] });

function grasp(event, raw, near) {
  const own = event.target.closest?.("[data-id]")?.dataset.id ?? "", [group] = find(own), rows = [...outlines(), ...at.draft.streets];
  if (["openings", "columns", "stairs"].includes(group)) { at.picked = own; return { thing: own, from: raw }; }
  const corner = rows.flatMap(pointsOf).find((one) => far(one, raw) < near);
  if (corner) { if (rows.every((row) => row.id !== at.picked)) at.picked = rows.find((row) => pointsOf(row).includes(corner)).id; return { points: [corner], from: corner }; }
  const wall = nearestSide(outlines(), raw);
  if (wall.far < near) {
    if (outlines().every((row) => row.id !== at.picked)) at.picked = wall.row.id;
    return { points: prolong(outlines(), wall.a, wall.b), from: wall.at, wall };
  }
  const again = own && own === at.picked;
  at.picked = ["rooms", "zones", "buildings", "streets"].includes(group) ? own : "";
  const points = moves(group) && (group === "buildings" || again) ? pointsOf(find(own)[1]) : [];
  return points.length ? { points, from: raw, whole: own, corner: points.reduce((a, b) => far(a, raw) < far(b, raw) ? a : b) } : pan(event);
}

$("draft").addEventListener("pointermove", (event) => {
  const raw = point(event), { press, tool } = at;
  if (press?.pan) {
    const by = scale();
    at.view = [press.start[0] - (event.clientX - press.from[0]) * by, press.start[1] - (event.clientY - press.from[1]) * by, at.view[2], at.view[3]];
  } else if (press?.scale) at.here = raw;
  else if (press?.stairs) at.here = raw;
  else if (press?.whole) {
    const [x, y] = press.corner, spot = caught([x + raw[0] - press.from[0], y + raw[1] - press.from[1]], event);
    at.shift = { id: press.whole, by: [spot[0] - x, spot[1] - y] };
  } else if (press?.points) {
    const spot = caught(raw, event, press.from), by = [spot[0] - press.from[0], spot[1] - press.from[1]];
    if (press.wall) {
      const { a, b } = press.wall, long = far(a, b), n = [-(b[1] - a[1]) / long, (b[0] - a[0]) / long], out = by[0] * n[0] + by[1] * n[1];
      by[0] = n[0] * out; by[1] = n[1] * out;
    }
    at.shift = { points: press.points, by };
  } else if (press?.thing) {
    const [group, one] = find(press.thing);
    one.at = group === "openings" ? wallAt(raw, event).at ?? one.at : caught(raw, event);
    press.moved = true;
  } else if (["room", "zone", "building", "street", "path"].includes(tool)) at.here = caught(raw, event, press?.from ?? at.poly.at(-1));
  else if (["door", "passage", "window"].includes(tool)) { at.here = raw; at.here.wall = wallAt(raw, event); }
  else return;
  show();
});

$("draft").addEventListener("pointerup", async (event) => {
  const done = at.press; at.press = null; at.guides = [];
  if (done?.scale) {
    const [from, until] = [at.poly[0], at.here], long = far(from, until);
    Object.assign(at, { poly: [], here: null }); show();
    if (at.under && long > 0.05) typeOver([(from[0] + until[0]) / 2, (from[1] + until[1]) / 2], "", (metres) => { at.under.width *= metres / long; choose("room"); });
  } else if (done?.rectangle) {
    const least = 3 * kind().grid;
    if (Math.min(Math.abs(at.here[0] - done.from[0]), Math.abs(at.here[1] - done.from[1])) >= least) await finish(rectangle(done.from, at.here));
    else { at.poly = [done.from]; show(); }
  } else if (done?.stairs) {
    after = () => { at.tool = "select"; pick("stairs")(); };
    await act({ act: "stairs", at: done.from, heading: Math.round(Math.atan2(at.here[1] - done.from[1], at.here[0] - done.from[0]) / (Math.PI / 12)) * Math.PI / 12 });
  } else if (done?.points && at.shift) {
    const asked = at.shift; at.shift = null;
    if (Math.hypot(...asked.by) > 0.005) await act({ act: asked.id ? "shift" : "move", ...asked }); else show();
  } else if (done?.thing && done.moved) {
    await act({ act: "set", id: done.thing, key: "at", value: find(done.thing)[1].at });
  } else if (done?.pan && far([event.clientX, event.clientY], done.from) < 4) show();
});

$("draft").addEventListener("wheel", (event) => {
  event.preventDefault();
  const [x, y] = point(event), by = Math.exp(event.deltaY * 0.0012), { view } = at;
  at.view = [x + (view[0] - x) * by, -y + (view[1] + y) * by, view[2] * by, view[3] * by];
  show();
}, { passive: false });

// A field over the drawing that takes a length.
function typeOver([x, y], value, done) {
  const input = $("typed"), area = $("drawing").getBoundingClientRect(), spot = new DOMPoint(x, -y).matrixTransform($("draft").getScreenCTM());
  Object.assign(input.style, { left: `${spot.x - area.x}px`, top: `${spot.y - area.y}px` });
  input.value = value; input.hidden = false;
  input.onkeydown = (event) => {
    if (event.key === "Escape") input.hidden = true;
    if (event.key !== "Enter") return;
    input.hidden = true; $("draft").focus();
    const metres = Number(input.value.replace(",", "."));
    if (metres > 0) done(metres);
  };
  setTimeout(() => { input.focus(); input.select(); });
}

function type(label) {
  const [, row] = find(label.dataset.row), edge = Number(label.dataset.edge), [a, b] = sides(row)[edge];
  at.picked = row.id; show();
  typeOver([(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], Number(label.dataset.long).toFixed(2), (metres) => act({ act: "length", id: row.id, edge, metres }));
}

$("under").onchange = async (event) => {
  const file = event.target.files[0];
  if (!file) return;
  const href = URL.createObjectURL(file), image = new Image();
  image.src = href; await image.decode().catch(() => say(t("this is no image")));
  if (!image.width) return;
  const width = kind().view[2] * 0.85, tall = image.height / image.width, edge = width / 12;
  at.under = { href, width, tall };
  at.view = [-edge, -width * tall - edge, width + 2 * edge, width * tall + 2 * edge];
  choose("scale");
};

// Digits while something is drawn: a length along the pointer's direction, or two of a rectangle.
function commitDigits() {
  const [width, depth] = at.digits.replaceAll(",", ".").split("x").map(Number), from = at.press?.from ?? at.poly.at(-1);
  at.digits = "";
  if (!from || !at.here || !(width > 0)) return;
  const sign = (axis) => at.here[axis] < from[axis] ? -1 : 1;
  if (depth > 0 && !isLine()) { finish(rectangle(from, [from[0] + sign(0) * width, from[1] + sign(1) * depth])); return; }
  const long = far(from, at.here) || 1;
  at.poly = [...(at.poly.length ? at.poly : [from]), [from[0] + (at.here[0] - from[0]) / long * width, from[1] + (at.here[1] - from[1]) / long * width]];
  at.press = null; show();
}

function nextSnap() { snapping = (snapping + 1) % SNAPS.length; show(); }

document.addEventListener("keydown", (event) => {
  if ($("drawing").hidden || event.target.matches("input, select, textarea") || document.querySelector("dialog[open]")) return;
  const key = event.key.toLowerCase(), begun = at.poly.length || at.press?.rectangle;
  if ((event.ctrlKey || event.metaKey) && key === "d" && !$("twin").hidden) { event.preventDefault(); $("twin").click(); }
  if (event.ctrlKey || event.metaKey) return;
  if (begun && /^[0-9.,x]$/.test(key)) { at.digits += key; show(); }
  else if (key === "backspace" && at.digits) { at.digits = at.digits.slice(0, -1); show(); }
  else if (key === "enter" && at.digits) commitDigits();
  else if (key === "enter" && at.poly.length > (isLine() ? 1 : 2)) finish(at.poly);
  else if (key === "escape") { at.picked = ""; choose(begun ? at.tool : "select"); }
  else if (key === "s") nextSnap();
  else if (key === "home") { frame(); show(); }
  else if (["delete", "backspace"].includes(key) && at.picked) $("erase").click();
  else if (TOOLS[key] && ["select", ...kind().tools].includes(TOOLS[key])) choose(TOOLS[key]);
  else return;
  event.preventDefault();
});

for (const button of $("tools").querySelectorAll("[data-tool]")) button.onclick = () => choose(button.dataset.tool);
$("snap").onclick = nextSnap;
$("erase").onclick = () => { const id = at.picked; at.picked = ""; act({ act: "remove", id }); };
// Another one like it, wall to wall beside it: the next house of a terrace.
$("twin").onclick = () => {
  const [group, row] = find(at.picked), xs = pointsOf(row).map((p) => p[0]);
  after = pick(group); act({ act: "shift", id: row.id, copy: true, by: [Math.max(...xs) - Math.min(...xs) || 5, 0] });
};
$("add-storey").onclick = () => {
  after = () => { at.level = at.draft.levels.at(-1).id; at.picked = ""; choose("select"); };
  act({ act: "storey", copy: $("copy-storey").checked });
};
$("erase-storey").onclick = () => act({ act: "remove", id: at.level });
const set = (id, key, own, read = (value) => value) => { $(id).onchange = () => act({ act: "set", id: own(), key, value: read($(id).value) }); };
const row = () => at.picked, plan = () => undefined, storey = () => at.level;
for (const [id, key] of [["room-name", "name"], ["opening-swing", "swing"], ["opening-hinge", "hinge"], ["street-name", "name"], ["street-kind", "kind"], ["stairs-shape", "shape"], ["stairs-turn", "turn"], ["building-use", "use"], ["building-roof", "roof"]]) set(id, key, row);
for (const [id, key] of [["opening-width", "width"], ["opening-sill", "sill"], ["street-width", "width"], ["stairs-width", "width"], ["column-size", "size"], ["building-height", "height"]]) set(id, key, row, Number);
set("stairs-heading", "heading", row, (degrees) => Number(degrees) * Math.PI / 180);
for (const [id, key] of [["plan-name", "name"], ["village-style", "style"]]) set(id, key, plan);
for (const [id, key] of [["wall", "wall_thickness"], ["outer-wall", "outer_wall_thickness"]]) set(id, key, plan, Number);
set("storey-name", "name", storey); set("storey-height", "height", storey, Number);
for (const id of ["room-name", "street-name"]) $(id).onkeydown = (event) => { if (["Enter", "Escape"].includes(event.key)) { $(id).blur(); $("draft").focus(); } };
