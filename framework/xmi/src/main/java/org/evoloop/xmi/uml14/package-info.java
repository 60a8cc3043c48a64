/**
 * UML 1.x in XMI 1.x, as written by ArgoUML, Poseidon, Enterprise Architect, StarUML 1 and their
 * contemporaries. Astah's files have a separate reader.
 *
 * <p>This package may use {@code org.evoloop.xmi.dialect}, {@code org.evoloop.statechart} and {@code
 * org.evoloop.statemachine}.
 */
@NullMarked
package org.evoloop.xmi.uml14;

import org.jspecify.annotations.NullMarked;
