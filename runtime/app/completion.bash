# SPDX-License-Identifier: MIT
# Completion of `strobe` in bash: the program itself says what the word before the cursor may become.
_strobe() {
  local line="${COMP_LINE:0:COMP_POINT}" word
  word="${line##*[[:space:]]}"
  mapfile -t COMPREPLY < <(strobe complete "$line" 2>/dev/null)
  # What bash replaces begins behind a "=", where that separates words.
  [[ "$COMP_WORDBREAKS" != *=* ]] || COMPREPLY=("${COMPREPLY[@]#"${word%"${word##*=}"}"}")
  [[ "${COMPREPLY[*]}" != *= ]] || compopt -o nospace
}
complete -o default -F _strobe strobe
