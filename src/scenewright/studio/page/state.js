// The server's state, as little of it as can be told: changes since the last one, and what pieces
// look like by keys, each asked for once.
import { read } from "/wire.js";

const looks = new Map(), MOST = 500;

// The state after a change (delta.py).
export function followChange(before, said) {
  if ("value" in said) return said.value;
  if ("keys" in said) {
    const after = { ...before };
    for (const key of said.gone ?? []) delete after[key];
    for (const [key, one] of Object.entries(said.keys)) after[key] = followChange(before[key], one);
    return after;
  }
  const items = [...before];
  for (const [index, one] of Object.entries(said.items ?? {})) items[index] = followChange(items[index], one);
  for (const [at, count, more] of [...said.cut ?? []].reverse()) items.splice(at, count, ...more);
  return items;
}

// What symbols look like, by key.
export async function learnLooks(keys) {
  const missing = [...new Set(keys)].filter((key) => !looks.has(key));
  for (let k = 0; k < missing.length; k += MOST) {
    for (const [key, look] of Object.entries(await read(`/symbols?of=${missing.slice(k, k + MOST)}`))) looks.set(key, look);
  }
  return looks;
}

// Pieces with all that is known of them, from the floor up.
export async function unfold(told) {
  const state = structuredClone(told), levels = state.levels ?? [], storey = new Map();
  for (const here of levels) for (const one of here.spaces) storey.set(one.id, here.id);
  await learnLooks((state.pieces ?? []).map((one) => one.is));
  const height = (one) => one.pose[2] + one.rise + (one.hangs && !one.flat ? 100 : 0);
  state.pieces = (state.pieces ?? []).flatMap((row) => {
    const space = row.in ?? (row.id.includes("/") ? row.id.split("/")[0] : ""), look = looks.get(row.is);
    return look ? [{ ...look, id: row.id, space, level: storey.get(space) ?? levels[0]?.id, pose: row.at, locked: !!row.locked, hangs: !!row.hangs }] : [];
  }).sort((a, b) => height(a) - height(b));
  return state;
}

// Layouts as they are told: shells by number, symbols by key.
export async function unpack(told) {
  const cards = Object.entries(told.cards ?? {}), looks = await learnLooks(cards.flatMap(([, { pieces }]) => pieces.map(([key]) => key)));
  return cards.map(([number, { shell, pieces }]) => [Number(number), {
    levels: told.shells[shell], pieces: pieces.map(([key, ...pose]) => [looks.get(key), ...pose]) }]);
}
