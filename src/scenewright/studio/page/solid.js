// The scene in 3D of what the server tells (solid.py): meshes by key, which the browser keeps, and
// where they are. What stands still is drawn together by room, what moves by itself.
import { BufferAttribute, BufferGeometry, Group, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, MeshStandardMaterial,
  RepeatWrapping, SRGBColorSpace, TextureLoader } from "/three.js";
import { decode, surface } from "/mesh.js";

const MANY = 8, GLOWS = 0.5, ABOVE = ["ceiling", "light row"];
const meshes = new Map(), pictures = new Map();
const toLinear = (value) => value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;

async function fetchMesh(key) {
  const reply = await fetch(`/mesh/${key}`);
  if (!reply.ok) throw new Error(`mesh ${key}: ${reply.status}`);
  return decode(await reply.arrayBuffer());
}

function meshOf(key) {
  if (!meshes.has(key)) meshes.set(key, fetchMesh(key).catch((error) => { meshes.delete(key); throw error; }));
  return meshes.get(key);
}

function pictureOf(address, coloured) {
  if (!pictures.has(address)) {
    const made = new TextureLoader().load(address);
    made.wrapS = made.wrapT = RepeatWrapping; made.anisotropy = 4;
    if (coloured) made.colorSpace = SRGBColorSpace;
    pictures.set(address, made);
  }
  return pictures.get(address);
}

// Materials that differ by colour alone are one, with the colour at the corners.
function kindOf({ roughness = 0.8, metallic = 0, opacity = 1, emission = 0, texture = "" }) {
  return JSON.stringify([texture, Math.round(4 * roughness) / 4, metallic > 0.5 ? 1 : 0, opacity, emission >= GLOWS]);
}

function makeMaterial(kind, textures) {
  const [texture, roughness, metalness, opacity, glows] = JSON.parse(kind), row = textures[texture];
  const seen = { vertexColors: true, opacity, transparent: opacity < 1, map: row ? pictureOf(row.picture, true) : null };
  if (glows) return new MeshBasicMaterial(seen);
  return new MeshStandardMaterial({ ...seen, roughness, metalness: 0.8 * metalness, normalMap: row?.relief ? pictureOf(row.relief, false) : null });
}

// A model: by body what of it is drawn in one kind of material each.
function split(parts, worn, { materials, textures }) {
  const bodies = new Map();
  parts.forEach((part, k) => {
    const material = materials[worn[k]], texture = textures[material.texture], kind = kindOf(material);
    const colour = material.color.map((value, axis) => toLinear(value) * (texture?.factor[axis] ?? 1));
    const name = part.joint?.body ?? "";
    if (!bodies.has(name)) bodies.set(name, { joint: part.joint, layers: new Map() });
    const { layers } = bodies.get(name);
    if (!layers.has(kind)) layers.set(kind, []);
    layers.get(kind).push({ ...surface(part, texture), colour });
  });
  return bodies;
}

// Surfaces at their places (x, y, z, turn) as one geometry, in three's axes: y up.
function geometryOf(rows) {
  const count = rows.reduce((sum, { one }) => sum + one.corners.length / 3, 0);
  const [corners, normals, colours, places] = [3, 3, 3, 2].map((width) => new Float32Array(width * count));
  let at = 0;
  for (const { one, place: [px, py, pz, turn] } of rows) {
    const [c, s] = [Math.cos(turn), Math.sin(turn)];
    for (let k = 0; k < one.corners.length; k += 3) {
      const [x, y, z] = one.corners.subarray(k, k + 3), [nx, ny, nz] = one.normals.subarray(k, k + 3), to = 3 * at + k;
      corners[to] = px + c * x - s * y; corners[to + 1] = pz + z; corners[to + 2] = -(py + s * x + c * y);
      normals[to] = c * nx - s * ny; normals[to + 1] = nz; normals[to + 2] = -(s * nx + c * ny);
      colours.set(one.colour, to);
    }
    places.set(one.places, 2 * at);
    at += one.corners.length / 3;
  }
  const made = new BufferGeometry();
  for (const [name, values, width] of [["position", corners, 3], ["normal", normals, 3], ["color", colours, 3], ["uv", places, 2]]) {
    made.setAttribute(name, new BufferAttribute(values, width));
  }
  return made;
}

const HERE = [0, 0, 0, 0];
const matrixAt = ([x, y, z, turn]) => new Matrix4().makeRotationY(turn).setPosition(x, z, -y);

// All of a told scene, what of it moves, doors, and what is above eyes.
export async function buildWorld(told) {
  const parts = await Promise.all(told.models.map(([key]) => meshOf(key)));
  const models = told.models.map(([, worn], k) => split(parts[k], worn, told));
  const materials = new Map(), world = new Group(), movable = [], doors = [], above = [];
  const materialOf = (kind) => { if (!materials.has(kind)) materials.set(kind, makeMaterial(kind, told.textures)); return materials.get(kind); };
  const put = (made, parent) => { made.castShadow = !made.material.transparent; made.receiveShadow = true; parent.add(made); return made; };
  const storeys = told.levels.map(([, elevation]) => { const made = new Group(); made.position.y = elevation; world.add(made); return made; });
  const counts = new Map(), together = new Map();
  for (const [, , , model] of told.things) counts.set(model, (counts.get(model) ?? 0) + 1);
  const many = new Map();
  for (const [name, kind, level, model, x, y, z, turn, room = ""] of told.things) {
    const place = [x, y, z, turn], bodies = models[model];
    for (const [body, { joint, layers }] of bodies) {
      if (body) { addBody(joint, layers, place, kind, storeys[level], name); continue; }
      if (counts.get(model) >= MANY) { const key = `${level} ${model}`; if (!many.has(key)) many.set(key, { level, layers, places: [] }); many.get(key).places.push(place); continue; }
      for (const [material, rows] of layers) {
        const over = ABOVE.includes(kind), key = JSON.stringify([level, room || kind, over, material]);
        if (!together.has(key)) together.set(key, { level, over, material, rows: [] });
        together.get(key).rows.push(...rows.map((one) => ({ one, place })));
      }
    }
  }
  for (const { level, over, material, rows } of together.values()) {
    const made = put(new Mesh(geometryOf(rows), materialOf(material)), storeys[level]);
    if (over) { made.castShadow = false; above.push(made); }
  }
  for (const { level, layers, places } of many.values()) for (const [material, rows] of layers) {
    const made = new InstancedMesh(geometryOf(rows.map((one) => ({ one, place: HERE }))), materialOf(material), places.length);
    places.forEach((place, k) => made.setMatrixAt(k, matrixAt(place)));
    put(made, storeys[level]);
  }

  // What moves: about its hinge, or along its runner.
  function addBody(joint, layers, place, kind, parent, name) {
    const { pivot: [x, y, z], axis: [ax, ay, az] } = joint, frame = new Group(), node = new Group();
    frame.applyMatrix4(matrixAt(place)); parent.add(frame);
    node.position.set(x, z, -y); frame.add(node);
    node.name = `${name} ${joint.body}`;
    node.userData = { joint: { ...joint, type: joint.kind, axis: [ax, az, -ay] }, rest: node.position.clone(), now: joint.at, aim: joint.at };
    for (const [material, rows] of layers) put(new Mesh(geometryOf(rows.map((one) => ({ one, place: [-x, -y, -z, 0] }))), materialOf(material)), node);
    movable.push(node);
    if (kind === "door" && joint.kind === "hinge") doors.push(node);
  }
  return { world, movable, doors, above, eyes: told.eyes };
}

export function forget(world) {
  world.traverse((node) => { node.geometry?.dispose(); node.material?.dispose(); });
}
