// What the columns of vcmetrics mean, in a line each, with their units.
const metrics = {
  Ev: ['illuminance at the eye, upright in the direction of the view', 'lx'],
  DGPf: ['daylight glare probability: the share of people who would be disturbed', ''],
  DGP: ['daylight glare probability, by whole pixels', ''],
  DGPu: ['daylight glare probability, by whole pixels, without the bias of noise', ''],
  UGR: ['unified glare rating, by whole pixels', ''],
  UGRf: ['unified glare rating', ''],
  DGI: ['daylight glare index, by whole pixels', ''],
  DGIf: ['daylight glare index', ''],
  VCP: ['visual comfort probability: the share of people who would not be disturbed, by whole pixels', '%'],
  Edir: ['illuminance at the eye from glare sources', 'lx'],
  Lavg: ['mean luminance of the picture', 'cd/m²'],
  Lmax: ['largest luminance of the picture', 'cd/m²'],
  Lmed: ['median luminance of the picture', 'cd/m²'],
  Lb: ['luminance of the background of the glare sources', 'cd/m²'],
  Lveil: ['veiling luminance: light that the eye scatters over the picture', 'cd/m²'],
  RAMMG: ['contrast of neighbouring pixels over all sizes of detail', 'cd/m²'],
  n_sources: ['number of glare sources', ''],
};
const regions = {
  TAL: ['mean luminance of', 'cd/m²'],
  mean: ['mean luminance of', 'cd/m²'],
  median: ['median luminance of', 'cd/m²'],
  min: ['least luminance of', 'cd/m²'],
  max: ['largest luminance of', 'cd/m²'],
  share: ['share of the view that is', ''],
  CR: ['contrast of the darker part to the brighter, of which above .25 a screen is hard to read:', ''],
  px: ['what the size of the pixels adds to', ''],
};

// [meaning, unit] of a column; a name of vcmetrics that is not here stands for itself.
export function meaning(name) {
  if (metrics[name]) return metrics[name];
  const dot = name.lastIndexOf('.'), [words, unit] = regions[name.slice(dot + 1)] ?? [];
  return dot > 0 && words ? [`${words} ${name.slice(0, dot)}`, unit] : [name, ''];
}
