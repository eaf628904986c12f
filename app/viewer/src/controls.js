// Mouse, touch and keyboard on the panes.

const clickReach = 5;  // pixels that a click may wander

export function listenToPointers(panes, turntable, {onPick, onActivate}) {
  const {canvas} = panes, pointers = new Map();
  let travelled = 0, several = false;

  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    const at = panes.paneAt(event.clientX, event.clientY);
    if (!at) return;
    const lines = event.deltaMode === 1 ? 30 : 1;
    turntable.zoom(Math.exp(0.0013 * lines * event.deltaY), at.pointer.x * at.aspect / 2, -at.pointer.y / 2, at.aspect);
    panes.redraw(true);
  }, {passive: false});
  canvas.addEventListener("dblclick", () => {
    turntable.reset();
    panes.redraw();
  });

  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    if (pointers.size === 0) travelled = 0;
    pointers.set(event.pointerId, event);
    several = pointers.size > 1;
    canvas.classList.add("dragging");
    const at = panes.paneAt(event.clientX, event.clientY);
    if (at) onActivate(at.i);
  });
  canvas.addEventListener("pointermove", event => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const {height, aspect} = panes.paneAt(last.clientX, last.clientY) ?? {height: canvas.clientHeight, aspect: 1};
    const dx = (event.clientX - last.clientX) / height, dy = (event.clientY - last.clientY) / height;
    travelled += height * Math.hypot(dx, dy);
    if (pointers.size === 2) {  // two fingers: move with them, zoom by their distance
      const other = [...pointers.values()].find(pointer => pointer.pointerId !== event.pointerId);
      const apart = pointer => Math.hypot(pointer.clientX - other.clientX, pointer.clientY - other.clientY);
      turntable.zoom(apart(last) / Math.max(1, apart(event)));
      turntable.move(dx / 2, dy / 2, aspect);
    } else if (event.shiftKey || event.buttons & 6) {
      turntable.move(dx, dy, aspect);
    } else {
      turntable.rotate(4 * dx, 4 * dy);
    }
    pointers.set(event.pointerId, event);
    panes.redraw(true);
  });
  const release = event => {
    const known = pointers.delete(event.pointerId);
    canvas.classList.toggle("dragging", pointers.size > 0);
    if (!known || event.type !== "pointerup" || event.button !== 0) return;
    if (several || travelled > clickReach || event.shiftKey) return;
    const at = panes.paneAt(event.clientX, event.clientY);
    if (at) onPick(at);
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
}

export function listenToKeys(panes, turntable, {onStage, onGrid, onEdges, onEscape}) {
  const step = 0.12;
  const actions = {
    ArrowLeft: () => turntable.rotate(-step, 0), ArrowRight: () => turntable.rotate(step, 0),
    ArrowUp: () => turntable.rotate(0, -step), ArrowDown: () => turntable.rotate(0, step),
    "+": () => turntable.zoom(0.85), "=": () => turntable.zoom(0.85), "-": () => turntable.zoom(1 / 0.85),
    r: () => turntable.reset(), a: onGrid, 0: onGrid, e: onEdges, Escape: onEscape,
  };
  window.addEventListener("keydown", event => {
    const typing = ["INPUT", "TEXTAREA", "SUMMARY"].includes(event.target.tagName);
    if (typing && event.target.type !== "checkbox" || event.ctrlKey || event.metaKey || event.altKey) return;
    const scrolls = event.key.startsWith("Arrow") && event.target.closest("aside");
    if (scrolls) return;
    const number = Number(event.key);
    if (number >= 1 && number <= panes.panes.length) {
      onStage(number - 1);
    } else if (Object.hasOwn(actions, event.key)) {
      actions[event.key]();
    } else {
      return;
    }
    event.preventDefault();
    panes.redraw();
  });
}
