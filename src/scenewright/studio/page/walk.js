// The scene in 3D: seen from above by turning it, or walked through at eye height. Metres; glTF's
// y points up.
import { AmbientLight, Box3, BufferAttribute, BufferGeometry, Color, DirectionalLight, Group, HemisphereLight, Mesh, MeshBasicMaterial,
  OrbitControls, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer, ACESFilmicToneMapping } from "/three.js";
import { buildWorld, forget } from "/solid.js";

const NEAR = 0.05, EYE = 1.6, PACE = 1.8, BODY = 0.3, OPENS = 1.9;
const farEnd = ({ lower, upper }) => Math.abs(upper) > Math.abs(lower) ? upper : lower;

// ``hands`` is what a pointer does with pieces: ``point`` at a place (x, y, z of the plan), ``grab`` it if it is
// the selected piece, ``drag`` by metres, ``drop``.
export function open3d(canvas, hands) {
  const renderer = new WebGLRenderer({ canvas, antialias: true });
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  renderer.toneMapping = ACESFilmicToneMapping;
  renderer.shadowMap.enabled = true;
  const scene = new Scene();
  scene.background = new Color(0xdfe6ea);
  const camera = new PerspectiveCamera(60, 1, NEAR, 2000);
  let held = { world: new Group(), movable: [], doors: [], above: [], eyes: {} }, lights = new Group();
  const turning = new OrbitControls(camera, canvas);
  turning.maxPolarAngle = 1.5;
  const spot = new Vector3(), ray = new Raycaster();
  let marks = new Group();
  const state = { keys: new Set(), walking: false, heading: 0, tilt: 0, alive: true, at: performance.now() };

  function resize() {
    const width = canvas.clientWidth, height = canvas.clientHeight;
    if (canvas.width !== width || canvas.height !== height) renderer.setSize(width, height, false);
    camera.aspect = width / Math.max(height, 1);
    // The farther off, the farther away the near plane: ground lies a centimetre over ground.
    camera.near = state.walking ? NEAR : Math.max(NEAR, 0.02 * camera.position.distanceTo(turning.target));
    camera.updateProjectionMatrix();
  }

  function look() {
    camera.lookAt(camera.position.x + Math.sin(state.heading) * Math.cos(state.tilt), camera.position.y + Math.sin(state.tilt),
      camera.position.z - Math.cos(state.heading) * Math.cos(state.tilt));
  }

  function step(seconds) {
    const has = (...names) => names.some((name) => state.keys.has(name));
    const ahead = has("w", "arrowup") - has("s", "arrowdown"), aside = has("d") - has("a");
    state.heading += (has("arrowright") - has("arrowleft")) * 1.6 * seconds;
    if (ahead || aside) {
      const way = new Vector3(Math.sin(state.heading) * ahead + Math.cos(state.heading) * aside, 0,
        -Math.cos(state.heading) * ahead + Math.sin(state.heading) * aside).normalize();
      go(way, PACE * (has("shift") ? 2 : 1) * seconds);
    }
    for (const door of held.doors) {
      if (door.getWorldPosition(spot).distanceTo(camera.position) < OPENS) door.userData.aim = farEnd(door.userData.joint);
    }
    look();
  }

  function go(way, far) {
    for (const share of [way, new Vector3(way.x, 0, 0), new Vector3(0, 0, way.z)]) {
      if (share.lengthSq() < 0.04) continue;
      const unit = share.clone().normalize();
      const blocked = [0.3, 0.9, 1.5].some((height) => {
        const from = camera.position.clone(); from.y += height - EYE;
        ray.set(from, unit); ray.near = 0; ray.far = BODY + far;
        const met = ray.intersectObjects(held.world.children, true);
        ray.far = Infinity;
        return met.some((hit) => !belongsToDoor(hit.object));
      });
      if (!blocked) { camera.position.addScaledVector(share, far); return; }
    }
  }

  const belongsToDoor = (object) => { for (let node = object; node; node = node.parent) if (held.doors.includes(node)) return true; return false; };

  // What moves goes to where it is meant to be, about its hinge or along its runner.
  function settle(seconds) {
    for (const { userData: facts, position, quaternion } of held.movable) {
      if (Math.abs(facts.aim - facts.now) < 1e-3) continue;
      facts.now += (facts.aim - facts.now) * Math.min(1, 5 * seconds);
      const axis = spot.fromArray(facts.joint.axis);
      if (facts.joint.type === "hinge") quaternion.setFromAxisAngle(axis, facts.now - facts.joint.at);
      else position.copy(facts.rest).addScaledVector(axis, facts.now - facts.joint.at);
    }
  }

  function aim(event) {
    const box = canvas.getBoundingClientRect();
    ray.setFromCamera(new Vector2(2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height), camera);
  }
  const met = (event) => { aim(event); return ray.intersectObjects(held.world.children, true).find((hit) => hit.object.visible); };
  const onPlan = ({ x, y, z }) => [x, -z, y];

  // Where the pointer is at a height.
  function atHeight(event, height) {
    aim(event);
    const { origin, direction } = ray.ray, far = (height - origin.y) / direction.y;
    return far > 0 ? onPlan(origin.clone().addScaledVector(direction, far)) : null;
  }

  // A click opens or shuts a door, a drawer, a sash, and selects what it is of.
  function touch(event) {
    const hit = met(event);
    let node = hit?.object;
    if (hit && !state.walking) hands.point(onPlan(hit.point));
    while (node && !held.movable.includes(node)) node = node.parent;
    if (!node) return;
    const { joint, aim } = node.userData, far = farEnd(joint);
    node.userData.aim = Math.abs(aim - far) < 0.1 ? (far === joint.upper ? joint.lower : joint.upper) : far;
  }

  function frame(now) {
    if (!state.alive) return;
    resize();
    const seconds = Math.min((now - state.at) / 1000, 0.1); state.at = now;
    if (state.walking) step(seconds); else turning.update();
    settle(seconds);
    for (const node of held.above) node.visible = state.walking;
    renderer.render(scene, camera);
    requestAnimationFrame(frame);
  }

  let grasped = null, started = null;
  let carried = null;
  const down = (event) => {
    grasped = started = [event.clientX, event.clientY];
    const hit = state.walking || event.button ? null : met(event);
    if (!hit || !hands.grab(onPlan(hit.point))) return;
    carried = { from: onPlan(hit.point), height: hit.point.y }; turning.enabled = false;
    canvas.setPointerCapture(event.pointerId);
  };
  const move = (event) => {
    const spot = carried && atHeight(event, carried.height);
    if (spot) hands.drag(spot[0] - carried.from[0], spot[1] - carried.from[1], event);
    if (!grasped || !state.walking) return;
    state.heading -= (event.clientX - grasped[0]) * 0.005;
    state.tilt = Math.max(-1.2, Math.min(1.2, state.tilt + (event.clientY - grasped[1]) * 0.005));
    grasped = [event.clientX, event.clientY];
  };
  const up = (event) => { if (carried) { carried = null; turning.enabled = !state.walking; hands.drop(); } if (started && Math.hypot(event.clientX - started[0], event.clientY - started[1]) < 4) touch(event); grasped = started = null; };
  const key = (event) => {
    if (!state.walking || event.key === "Escape") return;
    state.keys[event.type === "keydown" ? "add" : "delete"](event.key.toLowerCase());
    event.preventDefault();
  };
  canvas.addEventListener("pointerdown", down); canvas.addEventListener("pointermove", move); canvas.addEventListener("pointerup", up);
  addEventListener("keydown", key); addEventListener("keyup", key);
  requestAnimationFrame(frame);

  // Draw another scene; the first is looked at from above as a whole.
  async function show(told) {
    const fresh = await buildWorld(told), first = !held.world.parent;
    scene.remove(held.world, lights); forget(held.world);
    held = fresh;
    const box = new Box3().setFromObject(held.world), middle = box.getCenter(new Vector3()), size = box.getSize(new Vector3());
    lights = new Group();
    lights.add(new HemisphereLight(0xffffff, 0xb9a88f, 1.6), new AmbientLight(0xffffff, 0.5), sun(box, middle, size));
    scene.add(held.world, lights);
    if (!first) return;
    turning.target.copy(middle);
    camera.position.set(middle.x + 0.2 * size.x, middle.y + 0.75 * Math.max(size.x, size.z), middle.z + 0.55 * Math.max(size.x, size.z));
  }

  return {
    show,
    get eyes() { return held.eyes; },
    // Stand at a place of the plan (x, y and the floor's height), or look from above again.
    walk(x, y, floor, heading) {
      state.walking = true; turning.enabled = false;
      camera.fov = 70; camera.position.set(x, floor + EYE, -y);
      state.heading = Math.PI / 2 - heading; state.tilt = 0; look();
    },
    turn() { state.walking = false; turning.enabled = true; camera.fov = 60; },
    // What is seen now, as a picture.
    // Boxes about what is selected (x, y, z, heading, width, depth, height), red where it may not stand.
    mark(boxes, bad) {
      scene.remove(marks); forget(marks); marks = new Group();
      const material = new MeshBasicMaterial({ color: bad ? 0xd0342c : 0x14b8a6, transparent: true, opacity: 0.32, depthWrite: false, side: 2 });
      for (const box of boxes) marks.add(new Mesh(boxAt(box), material));
      scene.add(marks);
    },
    shot: () => { renderer.render(scene, camera); return new Promise((done) => { canvas.toBlob(done, "image/png"); }); },
    where: () => [camera.position.x, -camera.position.z, Math.PI / 2 - state.heading],
    press: (name, held_) => state.keys[held_ ? "add" : "delete"](name),
    close() {
      state.alive = false; turning.dispose(); renderer.dispose();
      removeEventListener("keydown", key); removeEventListener("keyup", key);
      canvas.removeEventListener("pointerdown", down); canvas.removeEventListener("pointermove", move);
      canvas.removeEventListener("pointerup", up);
    },
  };
}

const FACES = [0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3];
function boxAt([x, y, z, heading, width, depth, height]) {
  const [c, s] = [Math.sin(heading), -Math.cos(heading)], made = new BufferGeometry(), corners = [];
  for (const a of [-1, 1]) for (const b of [-1, 1]) for (const up of [0, 1]) {
    const [dx, dy] = [a * (width / 2 + 0.01), b * (depth / 2 + 0.01)];
    corners.push(x + c * dx - s * dy, z + up * (height + 0.01), -(y + s * dx + c * dy));
  }
  made.setAttribute("position", new BufferAttribute(new Float32Array(corners), 3));
  made.setIndex(FACES);
  return made;
}

function sun(box, middle, size) {
  const light = new DirectionalLight(0xfff1dc, 2.2), reach = 0.75 * Math.max(size.x, size.z, size.y);
  light.position.set(middle.x - reach, box.max.y + 1.4 * reach, middle.z + 0.7 * reach);
  light.target.position.copy(middle);
  light.castShadow = true;
  light.shadow.mapSize.set(2048, 2048);
  Object.assign(light.shadow.camera, { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1, far: 6 * reach });
  light.shadow.bias = -0.0005; light.shadow.normalBias = 0.02;
  const both = new Group(); both.add(light, light.target);
  return both;
}
