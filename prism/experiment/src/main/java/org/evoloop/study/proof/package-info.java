/** What the proof of the design takes from the code: the tables of model files, and what the real core does. */
@NullMarked
package org.evoloop.study.proof;

import org.jspecify.annotations.NullMarked;
