"use strict";
const run = JSON.parse(document.getElementById("run").textContent);
const dim = run.dimension, times = run.times, count = times.length;
const hues = ["#2672ab", "#cf5c0b", "#248642", "#6f59a7"];
const element = (id) => document.getElementById(id);

// the vector turned as a pose says
function turned(pose, v) {
  if (dim === 2) {
    const c = Math.cos(pose[2]), s = Math.sin(pose[2]);
    return [v[0] * c - v[1] * s, v[0] * s + v[1] * c];
  }
  const e0 = pose[3], e = pose.slice(4);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const inner = cross(e, v), outer = cross(e, inner.map((x, i) => x + e0 * v[i]));
  return v.map((x, i) => x + 2 * outer[i]);
}
const placed = (pose, v) => turned(pose, v).map((x, i) => x + pose[i]);
const home = dim === 2 ? [0, 0, 0] : [0, 0, 0, 1, 0, 0, 0];

// poses between two frames
function posesAt(time) {
  let k = frameAt(time);
  if (k + 1 >= count) return run.poses[k];
  const share = (time - times[k]) / (times[k + 1] - times[k] || 1);
  return run.poses[k].map((from, body) => {
    const to = run.poses[k + 1][body];
    let sign = 1;
    if (dim === 3) sign = Math.sign(from[3] * to[3] + from[4] * to[4] + from[5] * to[5] + from[6] * to[6]) || 1;
    const pose = from.map((x, i) => x + share * ((i > 2 ? sign : 1) * to[i] - x));
    if (dim === 3) {
      const length = Math.hypot(...pose.slice(3));
      for (let i = 3; i < 7; i++) pose[i] /= length;
    }
    return pose;
  });
}
// the last of increasing times that is not after one, or -1
function lastUpTo(list, time) {
  let low = -1, high = list.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (list[middle] <= time) low = middle; else high = middle - 1;
  }
  return low;
}
const frameAt = (time) => Math.max(0, lastUpTo(times, time));
const changes = run.events.map((event) => event.time);

// how far a body reaches from the origin of its frame
function reach(body) {
  let far = 0;
  for (const piece of body.pieces) {
    if (piece.polygon) for (const corner of piece.polygon) far = Math.max(far, Math.hypot(...corner));
    if (piece.disc) far = Math.max(far, Math.hypot(piece.disc[0], piece.disc[1]) + piece.disc[2]);
    if (piece.sphere) far = Math.max(far, Math.hypot(...piece.sphere.slice(0, 3)) + piece.sphere[3]);
    if (piece.box) far = Math.max(far, Math.hypot(...piece.box));
  }
  return far;
}
const reaches = run.bodies.map(reach);

function bounds(view) {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  run.poses.forEach((poses) => poses.forEach((pose, body) => {
    [view.right, view.up].forEach((axis, i) => {
      low[i] = Math.min(low[i], pose[axis] - reaches[body]);
      high[i] = Math.max(high[i], pose[axis] + reaches[body]);
    });
  }));
  if (!(low[0] < high[0] && low[1] < high[1])) return [[-1, -1], [1, 1]];
  const size = Math.max(high[0] - low[0], high[1] - low[1]);
  // what is fixed is shown as far as it is near
  const least = low.map((x) => x - 0.15 * size), most = high.map((x) => x + 0.15 * size);
  run.fixed.forEach((fixed) => fixed.pieces.forEach((piece) => extent(piece).forEach((point) => {
    [view.right, view.up].forEach((axis, i) => {
      low[i] = Math.min(low[i], Math.max(point[axis], least[i]));
      high[i] = Math.max(high[i], Math.min(point[axis], most[i]));
    });
  })));
  return [low.map((x) => x - 0.08 * size), high.map((x) => x + 0.08 * size)];
}
// points that a view of a piece must hold
function extent(piece) {
  const round = piece.disc || piece.sphere;
  if (piece.polygon) return piece.polygon;
  if (round) return [1, -1].map((sign) => round.slice(0, dim).map((x) => x + sign * round[dim]));
  if (piece.box) return [piece.box, piece.box.map((x) => -x)];
  return [];
}

const stages = run.views.map((view) => {
  const box = document.createElement("div"), name = document.createElement("p");
  const canvas = document.createElement("canvas");
  box.className = "view";
  name.textContent = view.name;
  if (view.name) box.append(name);
  box.append(canvas);
  element("views").append(box);
  return { view, canvas, bounds: bounds(view) };
});

function fit(canvas, height) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth;
  canvas.style.height = height + "px";
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const pen = canvas.getContext("2d");
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  return [pen, width, height];
}

function outline(pen, points) {
  pen.beginPath();
  points.forEach((at, i) => (i ? pen.lineTo(at[0], at[1]) : pen.moveTo(at[0], at[1])));
  pen.closePath();
}

// corners of the convex hull
function hull(points) {
  points.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list) => {
    const kept = [];
    for (const p of list) {
      while (kept.length > 1) {
        const a = kept[kept.length - 2], b = kept[kept.length - 1];
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        kept.pop();
      }
      kept.push(p);
    }
    kept.pop();
    return kept;
  };
  return half(points).concat(half(points.slice().reverse()));
}

function drawPieces(pen, pieces, pose, toPage, scale, view, far) {
  const seen = (v) => [v[view.right], v[view.up]];
  for (const piece of pieces) {
    if (piece.polygon) {
      outline(pen, piece.polygon.map((corner) => toPage(seen(placed(pose, corner)))));
      pen.fill(); pen.stroke();
    } else if (piece.disc || piece.sphere) {
      const values = piece.disc || piece.sphere, radius = values[dim];
      const center = values.slice(0, dim), at = toPage(seen(placed(pose, center)));
      pen.beginPath();
      pen.arc(at[0], at[1], Math.max(radius * scale, 2), 0, 2 * Math.PI);
      pen.fill(); pen.stroke();
      // lines on the surface show how it turns
      const circles = dim === 2 ? [] : [[0, 1], [1, 2], [2, 0]];
      if (dim === 2 && radius > 0) {
        const rim = toPage(seen(placed(pose, [center[0] + radius, center[1]])));
        pen.beginPath(); pen.moveTo(at[0], at[1]); pen.lineTo(rim[0], rim[1]); pen.stroke();
      }
      const depth = 3 - view.right - view.up, front = view.up === 2 ? -1 : 1;
      for (const [a, b] of circles) {
        let isDown = false;
        pen.beginPath();
        for (let i = 0; i <= 48; i++) {
          const v = center.slice(), angle = (i * Math.PI) / 24;
          v[a] += radius * Math.cos(angle);
          v[b] += radius * Math.sin(angle);
          const p = placed(pose, v), here = toPage(seen(p));
          const isFront = front * (p[depth] - placed(pose, center)[depth]) >= 0;
          if (isFront && isDown) pen.lineTo(here[0], here[1]); else pen.moveTo(here[0], here[1]);
          isDown = isFront;
        }
        pen.stroke();
      }
    } else if (piece.box) {
      const corners = [];
      for (let i = 0; i < 8; i++) corners.push(piece.box.map((h, axis) => ((i >> axis) & 1 ? h : -h)));
      const page = corners.map((corner) => toPage(seen(placed(pose, corner))));
      outline(pen, hull(page.slice()));
      pen.fill(); pen.stroke();
      pen.beginPath();
      for (let i = 0; i < 8; i++) for (const bit of [1, 2, 4]) {
        if (i & bit) continue;
        pen.moveTo(page[i][0], page[i][1]); pen.lineTo(page[i | bit][0], page[i | bit][1]);
      }
      pen.globalAlpha = 0.4; pen.stroke(); pen.globalAlpha = 1;
    } else if (piece.half) {
      const n = seen(piece.half.slice(dim)), length = Math.hypot(n[0], n[1]);
      if (length < 0.999) continue;
      const p = seen(piece.half.slice(0, dim)), t = [n[1], -n[0]];
      const corner = (along, down) => toPage([p[0] + along * t[0] - down * n[0], p[1] + along * t[1] - down * n[1]]);
      outline(pen, [corner(-far, 0), corner(far, 0), corner(far, far), corner(-far, far)]);
      pen.fill(); pen.stroke();
    }
  }
}

let largest = 0;
run.touches.forEach((list) => list.forEach((touch) => (largest = Math.max(largest, Math.hypot(...touch.impulse)))));

// pixels a metre, the same in all views
function commonScale() {
  const tallest = stages.length > 1 ? 340 : 520;
  const scales = stages.map(({ canvas, bounds: [low, high] }) =>
    Math.min(canvas.clientWidth / (high[0] - low[0]), tallest / (high[1] - low[1])));
  return Math.min(...scales);
}

function drawStage(stage, time, scale) {
  const [low, high] = stage.bounds, size = [high[0] - low[0], high[1] - low[1]];
  const [pen, width, height] = fit(stage.canvas, Math.max(120, size[1] * scale)), view = stage.view;
  const toPage = ([x, y]) => [
    width / 2 + (x - (low[0] + high[0]) / 2) * scale,
    height / 2 - (y - (low[1] + high[1]) / 2) * scale,
  ];
  const seen = (v) => [v[view.right], v[view.up]];
  const far = 4 * (size[0] + size[1]) + (width + height) / scale;
  pen.lineJoin = "round";
  pen.lineWidth = 1.2; pen.strokeStyle = "#6b7177"; pen.fillStyle = "#e4e8ec";
  run.fixed.forEach((fixed) => drawPieces(pen, fixed.pieces, home, toPage, scale, view, far));
  const poses = posesAt(time), frame = frameAt(time);
  if (element("paths").checked) run.bodies.forEach((body, number) => {
    pen.beginPath();
    pen.strokeStyle = "#9aa1a8"; pen.lineWidth = 1; pen.setLineDash([4, 3]);
    for (let k = 0; k < count; k += Math.ceil(count / 600)) {
      const at = toPage(seen(run.poses[k][number]));
      if (k) pen.lineTo(at[0], at[1]); else pen.moveTo(at[0], at[1]);
    }
    pen.stroke(); pen.setLineDash([]);
  });
  run.bodies.forEach((body, number) => {
    pen.strokeStyle = hues[number % hues.length]; pen.lineWidth = 1.6; pen.fillStyle = hues[number % hues.length] + "40";
    drawPieces(pen, body.pieces, poses[number], toPage, scale, view, far);
    const at = toPage(seen(poses[number]));
    pen.beginPath(); pen.arc(at[0], at[1], 2.5, 0, 2 * Math.PI); pen.fillStyle = "#2b2f33"; pen.fill();
  });
  if (element("impulses").checked && largest > 0) for (const touch of run.touches[frame] || []) {
    const impulse = seen(touch.impulse), strength = Math.hypot(...touch.impulse), flat = Math.hypot(...impulse);
    if (!(flat > 0)) continue;
    const length = (90 * Math.sqrt(strength / largest) * flat) / strength;
    const from = toPage(seen(touch.at)), way = [impulse[0] / flat, -impulse[1] / flat];
    const tip = [from[0] + way[0] * length, from[1] + way[1] * length];
    pen.strokeStyle = pen.fillStyle = "#d55e00"; pen.lineWidth = 2;
    pen.beginPath(); pen.moveTo(from[0], from[1]); pen.lineTo(tip[0], tip[1]); pen.stroke();
    const head = Math.min(8, length), side = [way[1], -way[0]];
    outline(pen, [tip, ...[1, -1].map((s) => [0, 1].map((i) => tip[i] - head * way[i] + s * 0.45 * head * side[i]))]);
    pen.fill();
  }
}

const graph = run.graph.values, unit = run.graph.unit;
element("graph").setAttribute("aria-label", run.graph.name + " over time");
if (!(largest > 0)) element("pushes").hidden = true;
const lowest = graph.reduce((a, b) => Math.min(a, b), Infinity);
const highest = graph.reduce((a, b) => Math.max(a, b), -Infinity);
function drawGraph(time) {
  const [pen, width, height] = fit(element("graph"), 90);
  const span = highest - lowest || 1;
  const end = times[count - 1] - times[0] || 1;
  const at = (k) => [60 + ((width - 72) * (times[k] - times[0])) / end, 10 + (height - 22) * (1 - (graph[k] - lowest) / span)];
  pen.strokeStyle = "#0072b2"; pen.lineWidth = 1.5;
  pen.beginPath();
  for (let k = 0; k < count; k++) { const [x, y] = at(k); if (k) pen.lineTo(x, y); else pen.moveTo(x, y); }
  pen.stroke();
  pen.fillStyle = "#6b7177"; pen.font = "11px Helvetica, Arial, sans-serif"; pen.textAlign = "right";
  pen.fillText(`${highest.toPrecision(3)} ${unit}`, 54, 14);
  pen.fillText(`${lowest.toPrecision(3)} ${unit}`, 54, height - 8);
  const x = 60 + ((width - 72) * (time - times[0])) / end;
  pen.strokeStyle = "#d55e00"; pen.lineWidth = 1;
  pen.beginPath(); pen.moveTo(x, 4); pen.lineTo(x, height - 4); pen.stroke();
}

let now = times[0] || 0, isPlaying = false, before = null;
function show() {
  if (!count) { element("now").textContent = "There are no frames to show."; return; }
  const scale = commonScale();
  stages.forEach((stage) => drawStage(stage, now, scale));
  drawGraph(now);
  const change = lastUpTo(changes, now), value = graph[frameAt(now)];
  const latest = change < 0 ? null : run.events[change];
  element("now").textContent = `${now.toFixed(4)} s, ${run.graph.name} ${value.toPrecision(5)} ${unit}` +
    (latest ? `; at ${latest.time.toPrecision(4)} s: ${latest.text}` : "");
  element("time").value = String(now);
  element("play").textContent = isPlaying ? "Pause" : "Play";
}
function tick(stamp) {
  if (!isPlaying) return;
  if (before !== null) now += ((stamp - before) / 1000) * Number(element("speed").value);
  before = stamp;
  if (now >= times[count - 1]) { now = times[count - 1]; isPlaying = false; }
  show();
  if (isPlaying) requestAnimationFrame(tick);
}
function toggle() {
  isPlaying = !isPlaying && count > 1;
  if (isPlaying && now >= times[count - 1]) now = times[0];
  before = null;
  show();
  if (isPlaying) requestAnimationFrame(tick);
}
function step(by) {
  isPlaying = false;
  now = times[Math.max(0, Math.min(count - 1, frameAt(now) + by))];
  show();
}
if (count) { element("time").min = String(times[0]); element("time").max = String(times[count - 1]); }
element("play").addEventListener("click", toggle);
element("time").addEventListener("input", () => { isPlaying = false; now = Number(element("time").value); show(); });
for (const id of ["impulses", "paths"]) element(id).addEventListener("change", show);
document.addEventListener("keydown", (key) => {
  if (key.target instanceof HTMLElement && ["INPUT", "SELECT", "BUTTON"].includes(key.target.tagName)) return;
  if (key.key === " ") { key.preventDefault(); toggle(); }
  if (key.key === "ArrowRight") step(1);
  if (key.key === "ArrowLeft") step(-1);
});
window.addEventListener("resize", show);
show();
