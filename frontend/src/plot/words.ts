/** Texts of plots, for the studio and for the replay in a report. */
export const words = {
  time: 'time [s]',
  none: 'Choose channels to plot.',
  name: (channels: string) => `Plot over time of ${channels || 'nothing yet'}`,
  axis: (unit: string) => (unit ? `[${unit}]` : ''),
} as const
