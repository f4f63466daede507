/* Did you mean ...? */
#ifndef NEAREST_H
#define NEAREST_H

/* The one of words (their end is NULL) for which word may be a slip: at most
 * every third letter of it wrong, left out, added or exchanged with the next;
 * else the first that begins as it does, for three letters or all of one.
 * Case doesn't count. NULL where there is none. */
const char *nearest(const char *word, const char *const *words);

#endif
