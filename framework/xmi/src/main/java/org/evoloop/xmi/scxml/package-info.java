/**
 * State Chart XML (W3C Recommendation of 2015), and what its drafts and their tools wrote. Where its algorithm and
 * UML's differ, a document is accepted only if both behave the same for it.
 *
 * <p>This package may use {@code org.evoloop.xmi.dialect}, {@code org.evoloop.statechart} and {@code
 * org.evoloop.statemachine}.
 */
@NullMarked
package org.evoloop.xmi.scxml;

import org.jspecify.annotations.NullMarked;
