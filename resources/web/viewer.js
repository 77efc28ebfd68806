// SPDX-License-Identifier: LGPL-2.1-or-later
// Shows the balloon of the page's GLB file in the place of its picture: it turns and zooms under mouse, fingers
// and keys. Light as in core/pictures/render.py. Without WebGL the picture stays.
"use strict";
(() => {
  const EYE = 3.6, START = [-0.49, 0.24, 1.25], link = document.getElementById("balloon-file");
  const image = document.getElementById("balloon-image"), canvas = document.createElement("canvas");
  const gl = link && image && canvas.getContext("webgl2", { alpha: true, antialias: true });
  if (!gl) return;

  const SEEN_FROM = `
    attribute vec3 position, normal; attribute vec2 place;
    uniform mat3 turn; uniform float reach; uniform vec2 lens;
    varying vec3 seen, facing; varying vec2 at;
    void main() {
      seen = turn * position / reach; facing = turn * normal; at = place;
      float away = ${EYE} - seen.z;
      gl_Position = vec4(lens * seen.xy, 4.5 * away - 15.4, away);
    }`;
  const LIT = `
    precision highp float;
    varying vec3 seen, facing; varying vec2 at;
    uniform vec4 colour; uniform float shine; uniform bool printed; uniform sampler2D picture;
    float studio(vec3 ray) {
      float sky = 0.22 + 0.42 * smoothstep(-0.3, 0.9, ray.y) + 0.16 * smoothstep(0.3, 1.0, -ray.y);
      float lamp = smoothstep(0.3, 0.65, ray.y) * (1.0 - smoothstep(0.85, 1.0, ray.y));
      float strip = smoothstep(0.5, 0.8, ray.x) * (1.0 - smoothstep(0.85, 1.0, ray.x));
      return sky + 0.5 * lamp * (1.0 - smoothstep(0.4, 0.8, abs(ray.x + 0.15)))
        + 0.3 * strip * smoothstep(-0.5, 0.2, ray.z);
    }
    void main() {
      vec3 film = colour.rgb * (printed ? texture2D(picture, at).rgb : vec3(1.0));
      vec3 normal = normalize(gl_FrontFacing ? facing : -facing), key = normalize(vec3(-0.45, 0.8, 0.65));
      if (!gl_FrontFacing) film *= 0.55;
      vec3 view = normalize(vec3(0.0, 0.0, ${EYE}) - seen), mirrored = 2.0 * dot(normal, view) * normal - view;
      float diffuse = 0.34 + 0.66 * max(dot(normal, key), 0.0) + 0.22 * (0.5 - 0.5 * normal.y);
      vec3 tint = film + (1.0 - film) * pow(1.0 - clamp(dot(normal, view), 0.0, 1.0), 4.0);
      vec3 light = film * mix(1.1, 0.6, shine) * diffuse + shine * 0.75 * tint * studio(mirrored);
      float glint = max(dot(mirrored, key), 0.0);
      light += shine * (0.55 * pow(glint, 60.0) + 0.12 * pow(glint, 12.0));
      gl_FragColor = vec4(pow(clamp(light, 0.0, 1.0), vec3(1.0 / 1.15)) * colour.a, colour.a);
    }`;

  const bytes = Uint8Array.from(atob(link.href.split(",")[1]), (letter) => letter.charCodeAt(0));
  const length = new DataView(bytes.buffer).getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
  const viewed = (number) => {
    const view = gltf.bufferViews[number], start = 28 + length + view.byteOffset;
    return bytes.subarray(start, start + view.byteLength);
  };

  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, SEEN_FROM], [gl.FRAGMENT_SHADER, LIT]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  ["position", "normal", "place"].forEach((name, number) => gl.bindAttribLocation(program, number, name));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return;
  gl.useProgram(program);
  const at = (name) => gl.getUniformLocation(program, name);

  const buffer = (kind, number) => {
    gl.bindBuffer(kind, gl.createBuffer());
    gl.bufferData(kind, viewed(gltf.accessors[number].bufferView), gl.STATIC_DRAW);
  };
  const screen = (light) => (light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055);
  const high = [0, 0, 0];
  const parts = gltf.meshes.flatMap((mesh) => mesh.primitives).map((primitive) => {
    const vertices = gl.createVertexArray(), indices = gltf.accessors[primitive.indices];
    const material = gltf.materials[primitive.material], surface = material.pbrMetallicRoughness;
    gl.bindVertexArray(vertices);
    ["POSITION", "NORMAL", "TEXCOORD_0"].forEach((name, number) => {
      if (!(name in primitive.attributes)) return;
      buffer(gl.ARRAY_BUFFER, primitive.attributes[name]);
      gl.enableVertexAttribArray(number);
      gl.vertexAttribPointer(number, number < 2 ? 3 : 2, gl.FLOAT, false, 0, 0);
    });
    buffer(gl.ELEMENT_ARRAY_BUFFER, primitive.indices);
    gltf.accessors[primitive.attributes.POSITION].max.forEach((end, k) => (high[k] = Math.max(high[k], end)));
    const factor = surface.baseColorFactor, texture = surface.baseColorTexture;
    return { vertices, count: indices.count, kind: indices.componentType, texture: texture && texture.index,
      colour: [...factor.slice(0, 3).map(screen), factor[3]], shine: 1 - surface.roughnessFactor ** 2,
      inside: material.doubleSided };
  });
  const textures = (gltf.textures || []).map(({ source }) => {
    const texture = gl.createTexture(), file = viewed(gltf.images[source].bufferView);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4).fill(200));
    createImageBitmap(new Blob([file], { type: "image/png" })).then((bitmap) => {
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
      gl.generateMipmap(gl.TEXTURE_2D);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
      redraw();
    });
    return texture;
  });

  let [yaw, pitch, zoom] = START, waiting = false;
  const draw = () => {
    waiting = false;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
    const lens = 6.6 * zoom, aspect = canvas.width / canvas.height;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.uniformMatrix3fv(at("turn"), false, [cy, sp * sy, -cp * sy, 0, cp, sp, sy, -sp * cy, cp * cy]);
    gl.uniform1f(at("reach"), 2 * Math.hypot(...high));
    gl.uniform2f(at("lens"), aspect > 1 ? lens / aspect : lens, aspect > 1 ? lens : lens * aspect);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    for (const part of parts) {
      gl.bindVertexArray(part.vertices);
      gl.uniform4fv(at("colour"), part.colour);
      gl.uniform1f(at("shine"), part.shine);
      gl.uniform1i(at("printed"), part.texture === undefined ? 0 : 1);
      if (part.texture !== undefined) gl.bindTexture(gl.TEXTURE_2D, textures[part.texture]);
      for (const hidden of part.inside || part.colour[3] < 1 ? [gl.FRONT, gl.BACK] : [gl.BACK]) {
        gl.cullFace(hidden);
        gl.drawElements(gl.TRIANGLES, part.count, part.kind, 0);
      }
    }
  };
  const redraw = () => {
    if (!waiting) requestAnimationFrame(draw);
    waiting = true;
  };
  const seenAs = (...view) => {
    [yaw, pitch, zoom] = view;
    redraw();
  };
  const turned = (right, down) => seenAs(yaw + right, Math.max(-1.57, Math.min(1.57, pitch + down)), zoom);
  const zoomed = (factor) => seenAs(yaw, pitch, Math.max(0.3, Math.min(12, zoom * factor)));
  const begin = () => seenAs(...START);

  const fingers = new Map();
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, event);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const other = [...fingers.values()].find((each) => each.pointerId !== event.pointerId);
    const apart = (one) => Math.max(1, Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY));
    fingers.set(event.pointerId, event);
    if (other) zoomed(apart(event) / apart(before));
    else turned(0.008 * (event.clientX - before.clientX), 0.008 * (event.clientY - before.clientY));
  });
  for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoomed(1.001 ** -event.deltaY);
  }, { passive: false });
  canvas.addEventListener("dblclick", begin);
  const KEYS = {
    ArrowLeft: () => turned(-0.15, 0), ArrowRight: () => turned(0.15, 0), "-": () => zoomed(0.87),
    ArrowUp: () => turned(0, -0.15), ArrowDown: () => turned(0, 0.15), "+": () => zoomed(1.15), Home: begin,
  };
  canvas.addEventListener("keydown", (event) => {
    if (!(event.key in KEYS) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    KEYS[event.key]();
  });
  canvas.addEventListener("webglcontextlost", () => { canvas.hidden = true; image.hidden = false; });

  gl.enable(gl.DEPTH_TEST);
  gl.enable(gl.CULL_FACE);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  canvas.tabIndex = 0;
  canvas.setAttribute("role", "application");
  canvas.setAttribute("aria-label", image.alt);
  canvas.setAttribute("aria-describedby", "balloon-keys");
  image.after(canvas);
  image.hidden = true;
  document.getElementById("balloon-keys").hidden = false;
  new ResizeObserver(redraw).observe(canvas);
})();
