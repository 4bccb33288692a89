// Questions to vcview: with the secret of the address, which the server asks for.
const token = location.hash.slice(1);

export const ask = (path, more = {}) => fetch(path, { ...more, headers: { ...more.headers, 'X-Luxpipe-Token': token } });

// Sends lines to ptrace's FIFO; an empty text: they have arrived, else why not.
export async function command(lines) {
  const answer = await ask('/control', { method: 'POST', body: lines });
  return answer.ok ? '' : (await answer.text()).trim();
}
