/** What stands above a field: the word of a parameter, and a sentence on it. */
export function FieldLabel({ word, sentence }: { word: string; sentence: string }) {
  return (
    <span className="label">
      {word}
      {sentence ? <span className="sentence">{sentence}</span> : null}
    </span>
  )
}
