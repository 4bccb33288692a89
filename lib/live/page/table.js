// Lists of things that can have the focus are one stop of the tab key; arrow keys go from one to the next.
export function one_stop(container, items) {
  const all = [...items], here = all.includes(document.activeElement) ? document.activeElement : all.find((e) => e.dataset.stop) ?? all[0];
  all.forEach((e) => { e.tabIndex = e === here ? 0 : -1; });
  container.onkeydown = (e) => {
    const by = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[e.key], to = by && all[all.indexOf(document.activeElement) + by];
    if (!to) return;
    e.preventDefault();
    e.stopPropagation();
    all.forEach((one) => { one.tabIndex = one === to ? 0 : -1; });
    to.focus();
  };
}

// New rows for a table whose rows can have the focus, which stays in its place.
export function fill_rows(body, rows) {
  const at = [...body.rows].indexOf(document.activeElement);
  body.replaceChildren(...rows);
  body.rows[at]?.focus({ preventScroll: true });
  one_stop(body, body.rows);
  if (at >= 0) body.rows[at]?.focus({ preventScroll: true });
}
