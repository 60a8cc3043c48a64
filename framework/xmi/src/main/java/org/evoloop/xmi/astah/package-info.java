/**
 * Astah's XMI 1.1 of an extended UML 1.4, bound with JAXB.
 *
 * <p>This package may use {@code org.evoloop.xmi.dialect}, {@code org.evoloop.statechart} and
 * {@code org.evoloop.statemachine}.
 */
@NullMarked
@XmlSchema(namespace = AstahXml.UML, elementFormDefault = XmlNsForm.QUALIFIED)
package org.evoloop.xmi.astah;

import jakarta.xml.bind.annotation.XmlNsForm;
import jakarta.xml.bind.annotation.XmlSchema;
import org.jspecify.annotations.NullMarked;
