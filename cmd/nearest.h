/* Which known word was meant by an unknown one. */
#ifndef NEAREST_H
#define NEAREST_H

/* Of words (NULL ends them) the one that is the fewest edits from word: letters
 * changed, added, left out or exchanged with the next. One edit is allowed for
 * two to five letters, and as many as a third of them for more. Where all are
 * further away, the first that is the beginning of word, or begins with it, in
 * three letters at least. Case doesn't count. NULL where there is none. */
const char *nearest(const char *word, const char *const *words);

#endif
