// New rows for a table whose rows can have the focus, which stays in its place.
export function fill_rows(body, rows) {
  const at = [...body.rows].indexOf(document.activeElement);
  body.replaceChildren(...rows);
  body.rows[at]?.focus({ preventScroll: true });
}
