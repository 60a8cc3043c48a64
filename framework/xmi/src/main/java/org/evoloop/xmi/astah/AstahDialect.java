package org.evoloop.xmi.astah;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.XmiDialect;
import org.evoloop.xmi.dialect.XmiHead;
import org.evoloop.xmi.dialect.XmiStream;

/**
 * XMI 1.1 of a UML 1.4 model as written by Astah (formerly JUDE). Machines may be anywhere in the model. The names of
 * their diagrams come after the model, in Astah's own extension, of which nothing else is needed.
 */
public final class AstahDialect implements XmiDialect {
    private static final String MENU = "Tools > XML Input & Output > Save as XML Project";

    /** The approximate memory for one machine's bookkeeping, besides its elements. */
    private static final int BYTES_PER_MACHINE = 500;

    private static final String EXPORTER = "Jomt XMI writer";
    private static final String JUDE = "http://objectclub.esm.co.jp/Jude/namespace/";

    /** Creates the JAXB bindings if they do not exist yet. */
    public static void prepare() {
        AstahUnmarshaller.prepare();
    }

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
    public List<DrawnMachine> read(XmiHead head, XmiStream stream) {
        return new Reading(stream).machines();
    }

    private static final class Reading {
        private final XmiStream stream;
        private final List<DrawnMachine> machines = new ArrayList<>();
        private final AstahFile file = new AstahFile();

        Reading(XmiStream stream) {
            this.stream = stream;
        }

        List<DrawnMachine> machines() {
            boolean more = stream.isStartElement() || stream.nextElementWithin(0);
            while (more) {
                if (atDefinition("StateMachine")) {
                    machine();
                    // JAXB leaves the stream after the end tag, possibly at a start tag.
                    more = stream.isStartElement() || stream.nextElementWithin(0);
                    continue;
                }
                if (stream.at(AstahXml.UML, "ActivityGraph")) {
                    stream.skipElement();
                } else if (stream.at(JUDE, "StateChartDiagram")) {
                    diagram();
                } else if (atDefinition("Event")) {
                    event(stream.attribute("xmi.id"), AstahNames.decode(stream.attribute("name")));
                }
                more = stream.nextElementWithin(0);
            }
            return machines;
        }

        /** The same element name is used for definitions and for references. */
        private boolean atDefinition(String localName) {
            return stream.at(AstahXml.UML, localName)
                    && stream.attribute("xmi.idref").isEmpty();
        }

        private void machine() {
            stream.keep(BYTES_PER_MACHINE);
            AstahUnmarshaller.Result result = AstahUnmarshaller.unmarshal(stream);
            result.events().forEach(event -> event(event.id(), event.name()));
            file.machines().putIfAbsent(result.machine().id(), result);
            machines.add(new AstahMachine(result, file));
        }

        private void event(String id, String name) {
            if (!id.isEmpty()) {
                stream.keep(id.length() + name.length());
                file.eventNames().put(id, name);
            }
        }

        private void diagram() {
            String name = AstahNames.tidy(stream.attribute("name"));
            int depth = stream.depth();
            boolean inModelRole = false;
            while (stream.nextElementWithin(depth)) {
                if (stream.depth() == depth + 1) {
                    inModelRole = stream.at(JUDE, "StateChartDiagram.semanticModel");
                } else if (inModelRole && stream.at(AstahXml.UML, "StateMachine")) {
                    String id = stream.attribute("xmi.idref");
                    stream.keep(id.length() + name.length());
                    file.diagramNames().putIfAbsent(id, name);
                }
            }
        }
    }
}
