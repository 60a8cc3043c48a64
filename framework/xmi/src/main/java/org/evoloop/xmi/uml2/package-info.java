/**
 * UML 2 in XMI 2.x, which most tools write, each in its own variant: Eclipse UML2 and Papyrus, Enterprise Architect,
 * MagicDraw and Cameo, StarUML. An element is identified by its type, not by the place where a tool
 * puts it.
 *
 * <p>This package may use {@code org.evoloop.xmi.dialect}, {@code org.evoloop.statechart} and {@code
 * org.evoloop.statemachine}.
 */
@NullMarked
package org.evoloop.xmi.uml2;

import org.jspecify.annotations.NullMarked;
