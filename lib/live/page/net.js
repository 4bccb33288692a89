// Questions to vcview: with the secret of the address, which the server asks for.
const token = location.hash.slice(1);

export class Lost extends Error {}  // the server does not answer

export const ask = (path, more = {}) => fetch(path, { ...more, headers: { ...more.headers, 'X-Luxpipe-Token': token } })
  .catch(() => { throw new Lost('vcview does not answer'); });

// A text as it is on the disk, byte for byte.
export async function text_of(answer, name) {
  const bytes = await answer.arrayBuffer().catch(() => { throw new Lost(`${name} has not come whole`); });
  try {
    return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    throw new Error(`${name} is no UTF-8`);
  }
}

export const tag_of = (answer) => answer.headers.get('ETag').replaceAll('"', '');

// Facts of a picture and its floats, as /next and /variant have them.
export async function unpack(answer) {
  const body = await answer.arrayBuffer().catch(() => { throw new Lost(); }),
        length = new DataView(body).getUint32(0, true);
  return {
    ...JSON.parse(new TextDecoder().decode(new Uint8Array(body, 4, length))),
    rgb: new Float32Array(body.slice(4 + length))
  };
}

// A question that changes something.  '' when that is done, else why not.
export async function post(path, body = '') {
  try {
    const answer = await ask(path, { method: 'POST', body });
    return answer.ok ? '' : (await answer.text()).trim();
  } catch (e) {
    return e.message;
  }
}

// Sends lines to ptrace's FIFO.
export const command = (lines) => post('/control', lines);
