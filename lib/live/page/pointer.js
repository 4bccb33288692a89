// The pointer on the picture: the part of the page that takes a press keeps it until it ends; a press that none takes
// moves the picture.  Two fingers and the wheel zoom.

// takers: objects with down(at, place, reach) -> taken, move(at, place, event), up(); hover(at): of a pixel, or null.
// click(at): of a pixel, where the pointer was pressed and has not moved.
export function follow(view, takers, hover, event_of_drag, click) {
  const canvas = view.canvas, fingers = new Map();
  let taker = null, last = null, pressed = null;

  const where = (e) => {
    const at = view.place(e.clientX, e.clientY);
    return [at, [at.x / view.image.width, 1 - at.y / view.image.height]];
  };

  canvas.addEventListener('pointerdown', (e) => {
    if (!view.image.width) return;
    canvas.setPointerCapture(e.pointerId);
    fingers.set(e.pointerId, e);
    last = pressed = e;
    if (fingers.size > 1) return;
    const [at, place] = where(e);
    taker = takers.find((t) => t.down(at, place, 1 / view.scale(), e)) ?? null;
  });

  canvas.addEventListener('pointermove', (e) => {
    if (!view.image.width) return;
    const [at, place] = where(e);
    if (fingers.size === 2) {
      const [a, b] = [...fingers.values()], before = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
      fingers.set(e.pointerId, e);
      const [c, d] = [...fingers.values()];
      view.zoomBy(Math.hypot(c.clientX - d.clientX, c.clientY - d.clientY) / (before || 1), (c.clientX + d.clientX) / 2,
        (c.clientY + d.clientY) / 2);
    } else if (taker) {
      taker.move(at, place, e);
    } else if (fingers.size) {
      if (!event_of_drag(e, at)) view.moveBy(e.clientX - last.clientX, e.clientY - last.clientY);
      last = e;
    } else {
      takers.forEach((t) => t.drawing && t.move(at, place, e));
    }
    hover(view.pixel(e.clientX, e.clientY));
  });

  const end = (e) => {
    fingers.delete(e.pointerId);
    const still =
      pressed?.pointerId === e.pointerId && Math.hypot(e.clientX - pressed.clientX, e.clientY - pressed.clientY) < 4;
    const at = !taker && still && e.type === 'pointerup' && view.pixel(e.clientX, e.clientY);
    if (at) click(at);
    taker?.up(e);
    taker = null;
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
  canvas.addEventListener('wheel', (e) => {
    e.preventDefault();
    view.zoomBy(2 ** (-e.deltaY / 300), e.clientX, e.clientY);
  }, { passive: false });
}
