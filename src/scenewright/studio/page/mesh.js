// Meshes as the server tells them (mesh_bytes.py), and what a graphics card wants of them: corners
// of faces with normals and places on textures, x, y, z up and metres as on the plan.
const CREASE = Math.cos(46 * Math.PI / 180), LEVEL = 0.93, CUTS = [0.7548776662466927, 0.5698402909980532], MOST = 64;

export function decode(buffer) {
  const bytes = new Uint8Array(buffer), end = bytes.indexOf(10);
  const { low, step, parts } = JSON.parse(new TextDecoder().decode(bytes.subarray(0, end)));
  let at = end + 1;
  const take = (kind, count) => { const found = new kind(buffer, at, count); at += 4 * Math.ceil(found.byteLength / 4); return found; };
  return parts.map(({ corners, faces, wide, joint }) => {
    const grid = take(Uint16Array, 3 * corners), steps = take(wide ? Int32Array : Int16Array, 3 * faces);
    const points = new Float32Array(3 * corners), places = new Float64Array(corners), index = new Uint32Array(3 * faces);
    for (let k = 0; k < corners; k += 1) {
      for (let axis = 0; axis < 3; axis += 1) points[3 * k + axis] = low[axis] + step[axis] * grid[axis * corners + k];
      places[k] = grid[k] * 2 ** 32 + grid[corners + k] * 2 ** 16 + grid[2 * corners + k];
    }
    for (let k = 0, corner = 0; k < 3 * faces; k += 1) index[k] = corner += steps[k];
    return { points, places, index, joint };
  });
}

// Of each face its normal, as long as twice its area, and of unit length.
function facesOf({ points, index }) {
  const across = new Float32Array(index.length), unit = new Float32Array(index.length);
  for (let f = 0; f < index.length; f += 3) {
    const [a, b, c] = [3 * index[f], 3 * index[f + 1], 3 * index[f + 2]];
    const [ux, uy, uz] = [points[b] - points[a], points[b + 1] - points[a + 1], points[b + 2] - points[a + 2]];
    const [vx, vy, vz] = [points[c] - points[a], points[c + 1] - points[a + 1], points[c + 2] - points[a + 2]];
    const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx], long = Math.hypot(x, y, z) || 1;
    across.set([x, y, z], f); unit.set([x / long, y / long, z / long], f);
  }
  return { across, unit };
}

// Normals at the corners of each face: the mean of faces that meet there at less than the crease.
function normalsOf({ places, index }, { across, unit }) {
  const ids = new Map(), point = new Uint32Array(index.length), fans = [];
  for (let k = 0; k < index.length; k += 1) {
    const place = places[index[k]];
    if (!ids.has(place)) { ids.set(place, fans.length); fans.push([]); }
    fans[point[k] = ids.get(place)].push(3 * Math.floor(k / 3));
  }
  const normals = new Float32Array(3 * index.length);
  for (let k = 0; k < index.length; k += 1) {
    const f = 3 * Math.floor(k / 3), fan = fans[point[k]];
    let [x, y, z] = [0, 0, 0];
    if (fan.length <= MOST) for (const g of fan) {
      if (unit[f] * unit[g] + unit[f + 1] * unit[g + 1] + unit[f + 2] * unit[g + 2] < CREASE) continue;
      x += across[g]; y += across[g + 1]; z += across[g + 2];
    }
    const long = Math.hypot(x, y, z);
    normals.set(long ? [x / long, y / long, z / long] : unit.subarray(f, f + 3), 3 * k);
  }
  return normals;
}

// The board of each corner: corners that faces join are of one.
function boardsOf({ points, index }) {
  const up = Uint32Array.from({ length: points.length / 3 }, (_, k) => k);
  const top = (k) => { while (up[k] !== k) k = up[k] = up[up[k]]; return k; };
  for (let f = 0; f < index.length; f += 3) {
    const [a, b, c] = [top(index[f]), top(index[f + 1]), top(index[f + 2])], least = Math.min(a, b, c);
    up[a] = up[b] = up[c] = least;
  }
  const numbers = new Map();
  return up.map((_, k) => { const head = top(k); if (!numbers.has(head)) numbers.set(head, numbers.size); return numbers.get(head); });
}

function bounds(rows, groups, width) {
  const low = new Map(), high = new Map();
  groups.forEach((group, k) => {
    if (!low.has(group)) { low.set(group, Array(width).fill(Infinity)); high.set(group, Array(width).fill(-Infinity)); }
    for (let axis = 0; axis < width; axis += 1) {
      const value = rows[width * k + axis];
      low.get(group)[axis] = Math.min(low.get(group)[axis], value); high.get(group)[axis] = Math.max(high.get(group)[axis], value);
    }
  });
  return { low, high };
}

// Places on a texture, as render/textures/projection.py lays them.
function layOn(part, { unit }, { laying, metres }) {
  const { points, index } = part, board = boardsOf(part), found = new Float32Array(2 * index.length);
  const whole = laying === "grain" ? bounds(points, board, 3) : null;
  for (let f = 0; f < index.length; f += 3) {
    const normal = [unit[f], unit[f + 1], unit[f + 2]], mine = board[index[f]];
    let ways, shift = [0, 0];
    if (whole) {
      const low = whole.low.get(mine), wide = whole.high.get(mine).map((value, axis) => value - low[axis]);
      const size = normal.map(Math.abs), seen = size.indexOf(Math.max(...size));
      wide[seen] = -1;
      const along = wide.indexOf(Math.max(...wide)), aside = 3 - seen - along;
      ways = [along, aside].map((axis) => [0, 1, 2].map((one) => Number(one === axis)));
      shift = [along, aside].map((axis, k) => 2 * ((mine + 1) * CUTS[k] % 1) - low[axis]);
    } else if (Math.abs(normal[2]) > LEVEL) ways = [[1, 0, 0], [0, 1, 0]];
    else {
      const long = Math.hypot(normal[0], normal[1]) || 1, [x, y] = [-normal[1] / long, normal[0] / long];
      ways = [[x, y, 0], [-normal[2] * y, normal[2] * x, normal[0] * y - normal[1] * x]];
    }
    for (let k = f; k < f + 3; k += 1) ways.forEach((way, axis) => {
      const at = 3 * index[k];
      found[2 * k + axis] = (points[at] * way[0] + points[at + 1] * way[1] + points[at + 2] * way[2] + shift[axis]) / metres[axis];
    });
  }
  return laying === "whole" ? stretch(found, index, board, unit) : found;
}

// Once over each board's faces that look the same way.
function stretch(places, index, board, unit) {
  const group = [...index].map((corner, k) => {
    const f = 3 * Math.floor(k / 3), way = [0, 1, 2].reduce((sum, axis) => sum + Math.sign(Math.round(10 * unit[f + axis])) * 3 ** axis, 0);
    return `${board[corner]} ${way}`;
  });
  const { low, high } = bounds(places, group, 2);
  return places.map((value, k) => {
    const of = group[k >> 1], axis = k & 1;
    return (value - low.get(of)[axis]) / Math.max(high.get(of)[axis] - low.get(of)[axis], 1e-9);
  });
}

// A part as corners of its faces, with places on its texture if it wears one.
export function surface(part, texture) {
  const { points, index } = part, faces = facesOf(part), corners = new Float32Array(3 * index.length);
  index.forEach((corner, k) => corners.set(points.subarray(3 * corner, 3 * corner + 3), 3 * k));
  return { corners, normals: normalsOf(part, faces), places: texture ? layOn(part, faces, texture) : new Float32Array(2 * index.length) };
}
