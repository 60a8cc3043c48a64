/**
 * Reads state machines from XMI files: one entry, {@link org.evoloop.xmi.XmiFile}, and behind it one {@code XmiDialect}
 * a tool; Astah's XMI 1.1 for now. Whatever a file holds, memory stays bounded and a problem becomes one
 * {@link org.evoloop.statemachine.ModelException} with file, line and mend.
 *
 * <p>This room may use {@code org.evoloop.statemachine} and nothing else of Evoloop.
 */
@NullMarked
@XmlSchema(namespace = AstahXml.UML, elementFormDefault = XmlNsForm.QUALIFIED)
package org.evoloop.xmi;

import jakarta.xml.bind.annotation.XmlNsForm;
import jakarta.xml.bind.annotation.XmlSchema;
import org.jspecify.annotations.NullMarked;
