/**
 * State Chart XML, the recommendation of the W3C of 2015, and what its drafts and their tools wrote before. Where its
 * algorithm and UML's differ, a document is read only if both do the same with it.
 *
 * <p>This package may use {@code org.evoloop.xmi.dialect}, {@code org.evoloop.statechart} and
 * {@code org.evoloop.statemachine}.
 */
@NullMarked
package org.evoloop.xmi.scxml;

import org.jspecify.annotations.NullMarked;
