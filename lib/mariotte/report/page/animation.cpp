#include "mariotte/report/page/animation.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "mariotte/report/figure/palette.hpp"
#include "mariotte/report/page/motion_frames.hpp"

namespace mariotte::report {
namespace {

constexpr const char* markup = R"(<h2>Moving picture</h2>
<figure class="moving">
<canvas id="stage" role="img" aria-label="The bodies and the forces between them, moving"></canvas>
<canvas id="timeline" aria-hidden="true"></canvas>
<div><button id="play" type="button">Play</button>
<input id="instant" type="range" min="0" value="0" step="1" aria-label="Instant">
<output id="clock"></output></div>
<figcaption id="legend"></figcaption>
</figure>
)";

// Lengths are in pixels, angles in radians. `at` is a frame, not necessarily a whole one.
constexpr const char* script = R"(
(function () {
  'use strict';
  const $ = id => document.getElementById(id);
  const data = JSON.parse($('motion').textContent);
  const last = data.time.length - 1, seconds = 8;
  const shown = i => data.discs[i].radius !== null;
  const radii = data.discs.filter(d => d.radius !== null).map(d => d.radius);
  const largest = rows => Math.max(...rows.map(row => Math.max(0, ...row.map(Math.abs))));
  const farthest = largest(data.move), strongest = largest(data.force) || 1;

  // 1, 2 or 5 times a power of ten, below what brings the motion to a third of the smallest radius.
  function magnification() {
    const wanted = Math.min(...radii) / 3 / farthest;
    if (data.floor || !(wanted > 1) || !isFinite(wanted)) return 1;
    const decade = 10 ** Math.floor(Math.log10(wanted));
    return decade * [5, 2, 1].find(digit => digit * decade <= wanted);
  }
  const factor = magnification();

  function row(rows, at) {
    const i = Math.min(Math.floor(at), last), k = Math.min(i + 1, last), part = at - i;
    return rows[i].map((value, n) => value + part * (rows[k][n] - value));
  }
  function places(at) {
    const move = row(data.move, at);
    return data.discs.map((d, i) => ({x: d.x + factor * move[2 * i], y: d.y + factor * move[2 * i + 1], radius: d.radius}));
  }
  function bounds() {
    const box = {left: Infinity, right: -Infinity, low: data.floor ? 0 : Infinity, high: -Infinity};
    for (let at = 0; at <= last; at += Math.max(1, last / 40)) for (const p of places(at)) {
      const r = p.radius || 0;
      box.left = Math.min(box.left, p.x - r); box.right = Math.max(box.right, p.x + r);
      box.low = Math.min(box.low, p.y - r); box.high = Math.max(box.high, p.y + r);
    }
    return box;
  }
  const box = bounds();

  function prepared(canvas, height) {
    const width = canvas.parentElement.clientWidth, dense = window.devicePixelRatio || 1;
    canvas.style.height = height + 'px';
    canvas.width = width * dense; canvas.height = height * dense;
    const pen = canvas.getContext('2d');
    pen.setTransform(dense, 0, 0, dense, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.strokeStyle = pen.fillStyle = getComputedStyle(canvas).color;
    pen.font = '13px system-ui, sans-serif';
    return {pen, width, height};
  }

  const room = 20;
  function view(width) {
    const wide = Math.max(box.right - box.left, 1e-300), high = Math.max(box.high - box.low, 1e-300);
    const tallest = Math.min(420, 0.75 * window.innerHeight);
    const scale = Math.min((width - 2 * room) / wide, (tallest - 2 * room) / high);
    const height = Math.max(110, scale * high + 2 * room);
    return {scale, height,
            x: v => width / 2 + scale * (v - (box.left + box.right) / 2),
            y: v => height / 2 - scale * (v - (box.low + box.high) / 2)};
  }

  // Corners of the convex hull of some points, in turn.
  function hull(points) {
    const sorted = [...points].sort((a, b) => a.x - b.x || a.y - b.y);
    const half = list => list.reduce((kept, p) => {
      const turns = (a, b) => (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0;
      while (kept.length > 1 && !turns(kept[kept.length - 2], kept[kept.length - 1])) kept.pop();
      return [...kept, p];
    }, []).slice(0, -1);
    return [...half(sorted), ...half(sorted.reverse())];
  }

  function outlines(pen, v, all) {
    for (const one of data.outlines || []) {
      pen.beginPath();
      for (const p of hull(one.map(i => all[i]))) pen.lineTo(v.x(p.x), v.y(p.y));
      pen.closePath();
      pen.save(); pen.globalAlpha = 0.12; pen.fill(); pen.restore(); pen.stroke();
    }
  }

  // Lines across the picture.
  function planes(pen, v, time) {
    const far = 2 * Math.max(box.right - box.left, box.high - box.low);
    pen.lineWidth = 4;
    for (const {x, y, normal: [a, b], speed} of data.planes || []) {
      const way = speed * time, cx = x + way * a, cy = y + way * b;
      const along = -b * ((box.left + box.right) / 2 - cx) + a * ((box.low + box.high) / 2 - cy);
      const line = k => [v.x(cx - b * (along + k)), v.y(cy + a * (along + k))];
      pen.beginPath(); pen.moveTo(...line(-far)); pen.lineTo(...line(far)); pen.stroke();
    }
  }

  function arrow(pen, x, y, dx, dy) {
    const size = Math.hypot(dx, dy), head = Math.min(9, 0.6 * size);
    if (size < 1.5) return;
    const ux = dx / size, uy = dy / size, ex = x + dx, ey = y + dy;
    pen.beginPath(); pen.moveTo(x, y); pen.lineTo(ex - head * ux, ey - head * uy); pen.stroke();
    pen.beginPath(); pen.moveTo(ex, ey);
    pen.lineTo(ex - head * (ux - 0.5 * uy), ey - head * (uy + 0.5 * ux));
    pen.lineTo(ex - head * (ux + 0.5 * uy), ey - head * (uy - 0.5 * ux)); pen.fill();
  }

  function bodies(pen, v, all, height) {
    pen.lineWidth = 1.5;
    for (const [a, b] of data.links) {
      pen.save(); pen.globalAlpha = 0.15; pen.lineWidth = 2 * v.scale * Math.min(all[a].radius, all[b].radius);
      pen.beginPath(); pen.moveTo(v.x(all[a].x), v.y(all[a].y)); pen.lineTo(v.x(all[b].x), v.y(all[b].y));
      pen.stroke(); pen.restore();
    }
    outlines(pen, v, all);
    all.forEach((p, i) => {
      const x = v.x(p.x), y = v.y(p.y), r = v.scale * (p.radius || 0);
      pen.beginPath();
      if (!shown(i)) { pen.save(); pen.lineWidth = 4; pen.moveTo(x, 8); pen.lineTo(x, height - 8); pen.stroke(); pen.restore(); return; }
      pen.arc(x, y, r, 0, 2 * Math.PI);
      pen.save(); pen.globalAlpha = 0.12; pen.fill(); pen.restore(); pen.stroke();
      if (r > 11 && all.length > 1 && !data.floor) {
        pen.textAlign = 'center'; pen.textBaseline = 'middle'; pen.fillText(String(i + 1), x, y - 0.55 * r);
      }
    });
    if (data.floor) { pen.lineWidth = 4; pen.beginPath(); pen.moveTo(0, v.y(0)); pen.lineTo(9999, v.y(0)); pen.stroke(); }
  }

  // Black lines take the colour of the text, which is bright on a dark page.
  function colour(j) {
    const name = data.colours[(data.contacts[j].same_as ?? j) % data.colours.length];
    return name === '#000000' ? getComputedStyle($('stage')).color : name;
  }
  function forces(pen, v, all, at) {
    const force = row(data.force, at), length = 0.95 * v.scale * Math.min(...radii);
    pen.lineWidth = 2.5;
    data.contacts.forEach((c, j) => {
      const push = force[j] / strongest * Math.max(28, length);
      const to = all[c.to], from = c.from < 0 ? null : all[c.from];
      let x, y;
      const [a, b] = c.normal || [0, 1];
      if (!from) { x = v.x(to.x - a * to.radius); y = v.y(to.y - b * to.radius); }
      else {
        const [nx, ny] = c.same_as === undefined ? [c.x, c.y] : [-c.y, c.x];  // friction is across
        if (to.radius === null) { x = v.x(from.x + nx * from.radius); y = v.y(from.y + ny * from.radius); }
        else { x = v.x(to.x - nx * to.radius); y = v.y(to.y - ny * to.radius); }
      }
      pen.strokeStyle = pen.fillStyle = colour(j);
      if (to.radius !== null) arrow(pen, x, y, push * c.x, -push * c.y);
      if (from && from.radius !== null) arrow(pen, x, y, -push * c.x, push * c.y);
    });
  }

  function timeline(at) {
    const {pen, width, height} = prepared($('timeline'), 60);
    const least = Math.min(0, ...data.force.map(f => Math.min(...f))), most = Math.max(...data.force.map(f => Math.max(...f)));
    const y = value => height - 4 - (height - 8) * (value - least) / ((most - least) || 1);
    const x = i => 8 + (width - 16) * i / last;
    pen.save(); pen.globalAlpha = 0.3; pen.beginPath(); pen.moveTo(8, y(0)); pen.lineTo(width - 8, y(0)); pen.stroke(); pen.restore();
    data.contacts.forEach((c, j) => {
      pen.strokeStyle = colour(j); pen.lineWidth = 1.5; pen.beginPath();
      data.force.forEach((f, i) => i === 0 ? pen.moveTo(x(i), y(f[j])) : pen.lineTo(x(i), y(f[j])));
      pen.stroke();
    });
    pen.strokeStyle = getComputedStyle($('timeline')).color; pen.lineWidth = 1.5;
    pen.beginPath(); pen.moveTo(x(at), 0); pen.lineTo(x(at), height); pen.stroke();
  }

  function unit(value, name, digits = 4) {
    const size = Math.abs(value);
    const [step, prefix] = [[1, ''], [1e-3, 'm'], [1e-6, 'µ'], [1e-9, 'n'], [1e-12, 'p']].find(one => size >= one[0]) || [1, ''];
    return (value / step).toPrecision(digits) + ' ' + prefix + name;
  }

  // Late in a run an instant needs more digits.
  const span = data.time[last] - data.time[0];
  const instant = Math.max(4, Math.min(12, Math.ceil(Math.log10(data.time[last] / span)) + 3));
  const steps = data.time.slice(1).map((t, i) => t - data.time[i]).sort((a, b) => a - b);
  const isSlowed = steps[Math.floor(0.8 * steps.length)] > 3 * steps[Math.floor(0.2 * steps.length)];
  let at = 0, playing = false, before = 0;
  function draw() {
    const v = view($('stage').parentElement.clientWidth);
    const {pen, height} = prepared($('stage'), v.height);
    const all = places(at);
    bodies(pen, v, all, height);
    planes(pen, v, row(data.time.map(t => [t]), at)[0]);
    forces(pen, v, all, at);
    timeline(at);
    $('instant').value = at;
    $('clock').textContent = 't = ' + unit(row(data.time.map(t => [t]), at)[0], 's', instant);
  }
  function tick(now) {
    if (!playing) return;
    at += Math.max(0, now - before) / 1000 / seconds * last;  // the first frame may have begun before
    before = now;
    if (at >= last) { at = last; pause(); }
    draw();
    if (playing) requestAnimationFrame(tick);
  }
  function pause() { playing = false; $('play').textContent = 'Play'; }
  function play() {
    if (at >= last) at = 0;
    playing = true; before = performance.now(); $('play').textContent = 'Pause';
    requestAnimationFrame(tick);
  }
  function go(to) { pause(); at = Math.max(0, Math.min(last, to)); draw(); }
  function drag(event) {
    if (event.buttons === 0) return;
    const place = $('timeline').getBoundingClientRect();
    go((event.clientX - place.left - 8) / (place.width - 16) * last);
  }

  $('instant').max = last; $('instant').step = 'any';
  $('instant').addEventListener('input', event => go(Number(event.target.value)));
  $('play').addEventListener('click', () => playing ? pause() : play());
  $('timeline').addEventListener('pointerdown', drag);
  $('timeline').addEventListener('pointermove', drag);
  window.addEventListener('resize', draw);
  $('legend').textContent = 'Arrows are forces; the longest is ' + unit(strongest, 'N') + '. ' +
    (factor > 1 ? 'Motion is magnified ' + factor + ' times. ' : '') +
    (data.axes ? 'Seen with ' + data.axes[0] + ' to the right and ' + data.axes[1] + ' upwards. ' : '') +
    (data.to_scale ? '' : 'Sizes of the bodies are not known. ') +
    (isSlowed ? 'It is slowest where forces act. ' : '') +
    'One pass takes ' + seconds + ' s for ' + unit(span, 's') + '. Drag along the forces to choose an instant.';
  at = data.force.findIndex(f => f.some(value => Math.abs(value) === strongest));
  if (at < 0) at = 0;
  draw();
})();
)";

/// Without "</script>", which a motion.json from elsewhere could have in its text.
std::string with_colours(Json motion) {
  motion["colours"] = line_colours;
  auto text = motion.dump();
  for (std::size_t at = 0; (at = text.find('<', at)) != text.npos;) text.replace(at, 1, "\\u003c");
  return text;
}

/// Balls or bodies; 0 of what may be neither.
std::size_t size(const Json& result) {
  const auto& end = result["final"];
  if (end.contains("bodies")) return end["bodies"].size();
  return result.value("model", "") == "chain" && end.contains("velocity") ? end["velocity"].size() : 0;
}

/// Why there is no moving picture.
std::string absence(const Json& result) {
  const auto count = size(result);
  const auto why =
      count > most_discs
          ? fmt::format(
                "There is none of {} bodies: of more than {} each would be too small to be "
                "seen move. The figures show all of them.",
                count, most_discs)
          : "There is none of this run: it shows balls and bodies whose places are known, over a run "
            "that has a trace.";
  return "<h2>Moving picture</h2>\n<p>" + why + "</p>\n";
}

}  // namespace

std::string animation(const Json& motion, const Json& result) {
  if (motion.empty()) return result.contains("final") ? absence(result) : "";
  return markup + std::string("<script id=\"motion\" type=\"application/json\">") + with_colours(motion) +
         "</script>\n<script>" + script + "</script>\n";
}

}  // namespace mariotte::report
