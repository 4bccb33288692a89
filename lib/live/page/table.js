// Lists of things that news change while people use them.

// The children of a container, one for each thing: made where its key is new, else kept in place and brought up to
// date.  So the focus, the caret, what is typed and a press that has begun outlive news.
export function keep(container, things, key_of, make, update = () => {}) {
  const active = document.activeElement, stops = () => [...container.querySelectorAll('input, button, [tabindex]')],
        at = stops().indexOf(active);
  const keys = things.map((thing) => String(key_of(thing))),
        kept = new Map([...container.children].map((e) => [e.dataset.key, e]));
  for (const [key, e] of kept) if (!keys.includes(key)) e.remove();
  things.forEach((thing, k) => {
    const e = kept.get(keys[k]) ?? make(thing), there = container.children[k];
    e.dataset.key = keys[k];
    if (there !== e) container.insertBefore(e, there ?? null);
    update(e, thing);
  });
  while (container.children.length > things.length) container.lastElementChild.remove();
  if (at >= 0 && document.activeElement !== active)
    (active.isConnected ? active : stops()[at])?.focus({ preventScroll: true });
}

// The value of a field as it is now known; what is being typed, or has been refused, stays.
export function fill(field, value) {
  if (field.defaultValue === String(value)) return;
  if (field !== document.activeElement || field.value === field.defaultValue) field.value = value;
  field.defaultValue = value;
}

export function row_of(cells) {
  const row = document.createElement('tr');
  for (let k = 0; k < cells; k++) row.insertCell();
  return row;
}

// Lists of things that can have the focus are one stop of the tab key; arrow keys go from one to the next.
export function one_stop(container, items) {
  const all = [...items], here = all.includes(document.activeElement) ? document.activeElement : all[0];
  all.forEach((e) => { e.tabIndex = e === here ? 0 : -1; });
  container.onkeydown = (e) => {
    const by = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[e.key],
          to = by && all[all.indexOf(document.activeElement) + by];
    if (!to) return;
    e.preventDefault();
    e.stopPropagation();
    all.forEach((one) => { one.tabIndex = one === to ? 0 : -1; });
    to.focus();
  };
}
