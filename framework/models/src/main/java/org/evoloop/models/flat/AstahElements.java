package org.evoloop.models.flat;

import java.io.StringWriter;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.evoloop.models.chart.ArcLabel;

/** Writes the elements of Astah's dialect, one per line. Names in UML elements are URL-encoded, as Astah does. */
final class AstahElements {
    private static final String UML = "org.omg.xmi.namespace.UML";
    private static final String JUDE = "http://objectclub.esm.co.jp/Jude/namespace/";

    private final StringWriter text = new StringWriter();
    private final XMLStreamWriter xml;

    AstahElements() {
        try {
            xml = XMLOutputFactory.newFactory().createXMLStreamWriter(text);
        } catch (XMLStreamException broken) {
            throw new IllegalStateException("no XML writer", broken);
        }
    }

    /** A writing step. Writing to memory cannot fail. */
    @FunctionalInterface
    private interface Step {
        void run() throws XMLStreamException;
    }

    private AstahElements write(Step step) {
        try {
            step.run();
        } catch (XMLStreamException broken) {
            throw new IllegalStateException("cannot write XML", broken);
        }
        return this;
    }

    /** Everything before the first machine. */
    void head() {
        write(() -> {
            xml.writeStartDocument("UTF-8", "1.0");
            xml.writeCharacters("\n");
            xml.writeStartElement("XMI");
            xml.writeAttribute("xmi.version", "1.1");
            xml.writeNamespace("JUDE", JUDE);
            xml.writeNamespace("UML", UML);
            xml.writeStartElement("XMI.header");
            xml.writeStartElement("XMI.documentation");
            xml.writeStartElement("XMI.exporter");
            xml.writeCharacters("Jomt XMI writer");
        });
        close(3);
        write(() -> xml.writeStartElement("XMI.content"));
        open("Model", "model", "").open("Namespace.ownedElement");
    }

    /** Everything after the last machine, including the diagram that names it. */
    String foot(String machineId, String diagramName) {
        close(2);
        write(() -> {
            xml.writeStartElement("XMI.extension");
            xml.writeStartElement("JUDE", "StateChartDiagram", JUDE);
            xml.writeAttribute("xmi.id", "diagram");
            xml.writeAttribute("name", diagramName);
            xml.writeStartElement("JUDE", "StateChartDiagram.semanticModel", JUDE);
        });
        reference("StateMachine", machineId);
        close(5);
        write(() -> {
            xml.writeEndDocument();
            xml.close();
        });
        return text.toString();
    }

    /** Opens a role: an element that only contains others. */
    AstahElements open(String role) {
        return write(() -> {
            xml.writeCharacters("\n");
            xml.writeStartElement("UML", role, UML);
        });
    }

    /** Opens an element with an id and a name. */
    AstahElements open(String element, String id, String name) {
        return open(element).write(() -> {
            xml.writeAttribute("xmi.id", id);
            xml.writeAttribute("name", URLEncoder.encode(name, StandardCharsets.UTF_8));
        });
    }

    AstahElements close(int levels) {
        return write(() -> {
            for (int level = 0; level < levels; level++) {
                xml.writeEndElement();
            }
        });
    }

    private void reference(String element, String id) {
        write(() -> {
            xml.writeEmptyElement("UML", element, UML);
            xml.writeAttribute("xmi.idref", id);
        });
    }

    void pseudostate(String id, String kind) {
        open("Pseudostate", id, "")
                .write(() -> xml.writeAttribute("kind", kind))
                .close(1);
    }

    /** A transition; empty parts are left out. */
    void transition(String id, String source, String target, String trigger, String guard, List<String> effects) {
        open("Transition", id, ArcLabel.of(trigger, guard, effects));
        actions("Transition.effect", id + "-a", effects);
        if (!guard.isEmpty()) {
            open("Transition.guard").open("Guard", id + "-g", guard).close(2);
        }
        if (!trigger.isEmpty()) {
            open("Transition.trigger").open("Event", id + "-e", trigger).close(2);
        }
        end("Transition.source", source);
        end("Transition.target", target);
        close(1);
    }

    /** Behaviors in their role; writes nothing if there are none. */
    void actions(String role, String idPrefix, List<String> names) {
        all(role, "Action", idPrefix, names);
    }

    private void all(String role, String element, String idPrefix, List<String> names) {
        if (!names.isEmpty()) {
            open(role);
            for (int i = 0; i < names.size(); i++) {
                open(element, idPrefix + i, names.get(i)).close(1);
            }
            close(1);
        }
    }

    /** The events that a state defers; writes nothing if there are none. */
    void deferrable(String idPrefix, List<String> events) {
        all("State.deferrableEvent", "Event", idPrefix, events);
    }

    private void end(String role, String vertex) {
        open(role);
        reference("StateVertex", vertex);
        close(1);
    }
}
