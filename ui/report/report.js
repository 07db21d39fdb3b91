"use strict";
(() => {
  const find = (id) => document.getElementById(id);
  const unit = 1 / 200;
  const stride = replay.joints * 3;
  const views = [
    {canvas: find("front"), across: 0, depth: 2, sign: 1},
    {canvas: find("side"), across: 2, depth: 0, sign: 1},
  ];
  const scrub = find("scrub"), timeline = find("timeline"), now = find("now");
  let step = 0, playing = 0;

  const bounds = [0, 1, 2].map((axis) => {
    let low = Infinity, high = -Infinity;
    for (const who of [replay.student, replay.coach])
      for (let i = axis; i < who.length; i += 3) {
        low = Math.min(low, who[i] * unit);
        high = Math.max(high, who[i] * unit);
      }
    return [low, high];
  });
  const spread = Math.max(bounds[0][1] - bounds[0][0], bounds[2][1] - bounds[2][0]);

  function drawBody(context, view, joints, colour, opacity, place) {
    const base = step * stride;
    const at = (joint) => {
      const i = base + joint * 3;
      return place(joints[i + view.across] * unit * view.sign, joints[i + 1] * unit);
    };
    context.globalAlpha = opacity;
    context.strokeStyle = context.fillStyle = colour;
    context.lineCap = context.lineJoin = "round";
    context.lineWidth = Math.max(3, 0.05 * place.scale);
    context.beginPath();
    for (const [a, b] of replay.bones) {
      context.moveTo(...at(a));
      context.lineTo(...at(b));
    }
    context.stroke();
    if (replay.head >= 0) {
      context.beginPath();
      context.arc(...at(replay.head), 0.095 * place.scale, 0, 2 * Math.PI);
      context.fill();
    }
  }

  function drawView(view) {
    const {canvas} = view, ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    if (width === 0) return;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    const context = canvas.getContext("2d");
    context.scale(ratio, ratio);
    const style = getComputedStyle(document.body);
    const scale = Math.min((width - 32) / Math.max(spread + 0.2, 0.5), (height - 56) / (bounds[1][1] + 0.12));
    const middle = 0.5 * (bounds[view.across][0] + bounds[view.across][1]);
    const place = (across, up) => [width / 2 + (across - middle) * scale, height - 24 - up * scale];
    place.scale = scale;
    context.strokeStyle = style.getPropertyValue("--line");
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(16, height - 20);
    context.lineTo(width - 16, height - 20);
    context.stroke();
    drawBody(context, view, replay.coach, style.getPropertyValue("--coach"), 0.8, place);
    drawBody(context, view, replay.student, style.getPropertyValue("--student"), 1, place);
  }

  function show(wanted) {
    step = Math.max(0, Math.min(replay.steps.length - 1, wanted));
    const [studentFrame, coachFrame, studentTime, coachTime, apart, speed, x, coachX, phase] = replay.steps[step];
    scrub.value = step;
    find("phase").textContent = phase;
    const tell = (id, value, detail) => {
      find(id).textContent = value;
      if (detail) find(id).appendChild(document.createElement("span")).textContent = detail;
    };
    tell("student-time", studentTime.toFixed(2) + " s", "frame " + studentFrame);
    tell("coach-time", coachTime.toFixed(2) + " s", "frame " + coachFrame);
    tell("apart", apart.toFixed(1) + " cm", "a joint in the mean");
    tell("speed", "× " + speed.toFixed(2), "of the coach’s");
    const [link, line, his, coachs] = now.children;
    const set = (element, values) => {
      for (const name in values) element.setAttribute(name, values[name]);
    };
    set(link, {x1: x, y1: replay.axis.student, x2: coachX, y2: replay.axis.coach});
    set(line, {x1: x, x2: x});
    set(his, {cx: x, cy: replay.axis.student});
    set(coachs, {cx: coachX, cy: replay.axis.coach});
    views.forEach(drawView);
  }

  function stop() {
    clearInterval(playing);
    playing = 0;
    find("play").textContent = "Play";
  }

  // At the student's own pace.
  function play() {
    if (playing) return stop();
    if (step === replay.steps.length - 1) show(0);
    find("play").textContent = "Pause";
    const begin = performance.now() - (replay.steps[step][2] - replay.steps[0][2]) * 1000;
    playing = setInterval(() => {
      const time = replay.steps[0][2] + (performance.now() - begin) / 1000;
      let next = step;
      while (next + 1 < replay.steps.length && replay.steps[next + 1][2] <= time) ++next;
      if (next !== step) show(next);
      if (next === replay.steps.length - 1) stop();
    }, 30);
  }

  scrub.addEventListener("input", () => { stop(); show(Number(scrub.value)); });
  find("play").addEventListener("click", play);
  timeline.addEventListener("pointermove", (event) => {
    const box = timeline.getBoundingClientRect();
    const x = (event.clientX - box.left) / box.width * 1000;
    stop();
    let nearest = 0;
    replay.steps.forEach((candidate, i) => {
      if (Math.abs(candidate[6] - x) < Math.abs(replay.steps[nearest][6] - x)) nearest = i;
    });
    show(nearest);
  });
  for (const column of timeline.querySelectorAll(".column"))
    column.addEventListener("click", () => show(Number(column.dataset.step)));
  for (const button of document.querySelectorAll(".moment"))
    button.addEventListener("click", () => {
      stop();
      show(Number(button.dataset.step));
      find("replay").scrollIntoView({behavior: "smooth"});
    });
  window.addEventListener("resize", () => show(step));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => show(step));

  const first = document.querySelector(".moment");
  show(first ? Number(first.dataset.step) : 0);
})();
