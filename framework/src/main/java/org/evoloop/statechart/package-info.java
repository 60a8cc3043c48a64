/**
 * State machines as UML draws them: hierarchy, orthogonal regions, pseudostates, guards and behaviors. The flat machine
 * that accepts the same events is made here too.
 *
 * <p>This room may use {@code org.evoloop.statemachine} alone.
 */
@NullMarked
package org.evoloop.statechart;

import org.jspecify.annotations.NullMarked;
