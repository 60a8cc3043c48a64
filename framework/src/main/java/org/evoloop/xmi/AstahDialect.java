package org.evoloop.xmi;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.xmi.AstahXml.Event;
import org.evoloop.xmi.AstahXml.Transition;
import org.evoloop.xmi.AstahXml.Transitions;

/**
 * XMI 1.1 of a UML 1.4 model as Astah (formerly JUDE) writes it. Machines stand anywhere in the model; the names of
 * their diagrams follow behind it, in an extension of Astah's own, of which nothing else is needed.
 */
final class AstahDialect implements XmiDialect {
    static final String MENU = "Tools > XML Input & Output > Save as XML Project";

    /** What the books about one machine cost besides its elements, about. */
    private static final int BYTES_PER_MACHINE = 500;

    private static final String EXPORTER = "Jomt XMI writer";
    private static final String JUDE = "http://objectclub.esm.co.jp/Jude/namespace/";

    @Override
    public boolean recognises(XmiHead head) {
        return head.root().getNamespaceURI().isEmpty()
                && head.root().getLocalPart().equals("XMI")
                && head.version().equals("1.1")
                && head.exporter().startsWith(EXPORTER);
    }

    @Override
    public String toString() {
        return "XMI 1.1 from Astah (" + MENU + ")";
    }

    @Override
    public List<XmiMachine> read(XmiStream stream) {
        return new Reading(stream).machines();
    }

    private static final class Reading {
        private final XmiStream stream;
        private final List<XmiMachine> machines = new ArrayList<>();
        private final Map<String, String> diagramNames = new HashMap<>();
        private final Map<String, String> eventNames = new HashMap<>();

        Reading(XmiStream stream) {
            this.stream = stream;
        }

        List<XmiMachine> machines() {
            boolean more = stream.isStartElement() || stream.nextElementWithin(0);
            while (more) {
                if (atDefinition("StateMachine")) {
                    machine();
                    // JAXB leaves the stream behind the end tag, maybe at a start tag.
                    more = stream.isStartElement() || stream.nextElementWithin(0);
                    continue;
                }
                if (stream.at(AstahXml.UML, "ActivityGraph")) {
                    stream.skipElement();
                } else if (stream.at(JUDE, "StateChartDiagram")) {
                    diagram();
                } else if (atDefinition("Event")) {
                    event(stream.attribute("xmi.id"), AstahXml.decode(stream.attribute("name")));
                }
                more = stream.nextElementWithin(0);
            }
            return machines;
        }

        /** The same element name serves definitions and references. */
        private boolean atDefinition(String localName) {
            return stream.at(AstahXml.UML, localName)
                    && stream.attribute("xmi.idref").isEmpty();
        }

        private void machine() {
            stream.keep(BYTES_PER_MACHINE);
            AstahUnmarshaller.Result result = AstahUnmarshaller.unmarshal(stream);
            for (Transitions role : result.machine().transitions) {
                for (Transition transition : role.transitions) {
                    for (Event event : transition.events()) {
                        event(event.id(), event.name());
                    }
                }
            }
            machines.add(new AstahMachine(stream.file(), result, diagramNames, eventNames));
        }

        private void event(String id, String name) {
            if (!id.isEmpty()) {
                stream.keep(id.length() + name.length());
                eventNames.put(id, name);
            }
        }

        private void diagram() {
            String name = AstahXml.tidy(stream.attribute("name"));
            int depth = stream.depth();
            boolean inModelRole = false;
            while (stream.nextElementWithin(depth)) {
                if (stream.depth() == depth + 1) {
                    inModelRole = stream.at(JUDE, "StateChartDiagram.semanticModel");
                } else if (inModelRole && stream.at(AstahXml.UML, "StateMachine")) {
                    String id = stream.attribute("xmi.idref");
                    stream.keep(id.length() + name.length());
                    diagramNames.putIfAbsent(id, name);
                }
            }
        }
    }
}
