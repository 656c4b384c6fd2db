export { AmbientLight, Box3, BufferAttribute, BufferGeometry, Color, DirectionalLight, HemisphereLight, InstancedMesh, Matrix4, Mesh,
  MeshBasicMaterial, MeshStandardMaterial, PerspectiveCamera, Raycaster, RepeatWrapping, Scene, TextureLoader, Vector2, Vector3,
  WebGLRenderer, ACESFilmicToneMapping, SRGBColorSpace, Group } from "three";
export { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
