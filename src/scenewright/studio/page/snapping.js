// Where a point of a drawing is meant to lie: on corners, lines, the grid, at angles; what is joined
// to a wall. Plain numbers, metres.
export const SNAPS = ["grid", "lines", "angles", "off"];
const ANGLE = Math.PI / 12, FINE = 0.01, HALF = 0.12;

export const far = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
export const to = (value, step) => Math.round(value / step) * step;
export const pointsOf = (row) => row.outline ?? row.line;
export const sides = (row) => { const at = pointsOf(row); return at.slice(0, row.line ? -1 : undefined).map((a, k) => [a, at[(k + 1) % at.length], k]); };

// Corners first, then lines through them, then the grid; angles from the last corner.
export function snap(raw, { how, corners, tolerance, grid, from = null }) {
  if (how === "off") return { at: raw.map((value) => to(value, FINE)), guides: [] };
  const corner = corners.find((one) => far(one, raw) < tolerance);
  if (corner) return { at: [...corner], guides: [] };
  if (how === "angles" && from) {
    const angle = to(Math.atan2(raw[1] - from[1], raw[0] - from[0]), ANGLE), long = to(far(raw, from), grid / 2);
    return { at: [from[0] + long * Math.cos(angle), from[1] + long * Math.sin(angle)], guides: [[from, raw]] };
  }
  const guides = [], rest = how === "lines" ? FINE : grid;
  const at = raw.map((value, axis) => {
    const near = corners.filter((one) => Math.abs(one[axis] - value) < tolerance).sort((a, b) => Math.abs(a[axis] - value) - Math.abs(b[axis] - value))[0];
    if (!near) return to(value, rest);
    guides.push([near, axis ? [raw[0], near[1]] : [near[0], raw[1]]]);
    return near[axis];
  });
  return { at, guides };
}

export function nearestSide(rows, at) {
  let best = { far: Infinity };
  for (const row of rows) for (const [a, b, k] of sides(row)) {
    const along = [b[0] - a[0], b[1] - a[1]], long = along[0] ** 2 + along[1] ** 2 || 1e-9;
    const share = Math.min(1, Math.max(0, ((at[0] - a[0]) * along[0] + (at[1] - a[1]) * along[1]) / long));
    const foot = [a[0] + share * along[0], a[1] + share * along[1]];
    if (far(foot, at) < best.far) best = { far: far(foot, at), row, k, a, b, at: foot };
  }
  return best;
}

// A place on the nearest wall: its middle is caught, else whole steps of the grid.
export function onWall(rooms, at, { how, grid }) {
  const wall = nearestSide(rooms, at);
  if (!(wall.far <= 0.6) || how === "off") return wall;
  const long = far(wall.a, wall.b), part = far(wall.a, wall.at), share = (Math.abs(part - long / 2) < HALF ? long / 2 : to(part, grid)) / long;
  return { ...wall, at: [wall.a[0] + share * (wall.b[0] - wall.a[0]), wall.a[1] + share * (wall.b[1] - wall.a[1])] };
}

// What the server does with a moved corner or wall, shown while it is dragged.
const liesOn = (at, points) => points.some((one) => far(one, at) < 1e-6)
  || points.length === 2 && Math.abs(far(points[0], at) + far(at, points[1]) - far(...points)) < 1e-6;
export const shifted = (row, shift) => shift && (!shift.id || shift.id === row.id) ? pointsOf(row).map((at) => shift.id || liesOn(at, shift.points) ? [at[0] + shift.by[0], at[1] + shift.by[1]] : at) : pointsOf(row);

// A wall with the walls in one line with it that it is joined to, as the server moves them.
export function prolong(rows, a, b) {
  const long = far(a, b), u = [(b[0] - a[0]) / long, (b[1] - a[1]) / long];
  const off = (p) => Math.abs((p[1] - a[1]) * u[0] - (p[0] - a[0]) * u[1]), part = (p) => (p[0] - a[0]) * u[0] + (p[1] - a[1]) * u[1];
  const spans = rows.flatMap(sides).filter(([p, q]) => off(p) < 1e-6 && off(q) < 1e-6).map(([p, q]) => [part(p), part(q)].sort((x, y) => x - y));
  let low = 0, high = long;
  for (const _ of spans) for (const [from, until] of spans) if (from <= high + 1e-6 && until >= low - 1e-6) { low = Math.min(low, from); high = Math.max(high, until); }
  return [low, high].map((at) => [a[0] + u[0] * at, a[1] + u[1] * at]);
}

export function middle(ring) {
  let area = 0, x = 0, y = 0;
  ring.forEach(([ax, ay], k) => {
    const [bx, by] = ring[(k + 1) % ring.length], cross = ax * by - bx * ay;
    area += cross / 2; x += (ax + bx) * cross / 6; y += (ay + by) * cross / 6;
  });
  return { area, at: Math.abs(area) < 1e-9 ? ring[0] : [x / area, y / area] };
}
