package org.evoloop.xmi.astah;

import jakarta.xml.bind.JAXBContext;
import jakarta.xml.bind.JAXBException;
import jakarta.xml.bind.Unmarshaller;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import javax.xml.XMLConstants;
import javax.xml.stream.util.StreamReaderDelegate;
import org.evoloop.xmi.dialect.Problems;
import org.evoloop.xmi.dialect.XmiStream;
import org.jspecify.annotations.Nullable;

/**
 * Unmarshals one {@code UML:StateMachine} from the stream, and reports everything in it that has no binding. JAXB would
 * ignore that silently. An element has a binding exactly if JAXB creates an object for it, which its listener reports
 * before the next event is read.
 */
final class AstahUnmarshaller extends StreamReaderDelegate {
    /** Elements that repeat others. */
    private static final Set<String> REPEATED =
            Set.of("StateVertex.container", "StateVertex.outgoing", "StateVertex.incoming", "Transition.stateMachine");

    private static final Set<String> WITHOUT_MEANING =
            Set.of("StateMachine.context", "ModelElement.taggedValue", "ModelElement.comment", "XMI.extension");

    private final XmiStream stream;
    private final Problems problems = new Problems();
    private final Map<String, Integer> linesById = new HashMap<>();
    private final Map<String, Reference> references = new HashMap<>();
    private final Set<String> refusedIds = new HashSet<>();
    private final List<AstahXml.Event> events = new ArrayList<>();
    private AstahXml.@Nullable Element open;
    private boolean bound = true;

    private record Reference(int line, AstahXml.@Nullable Element owner) {}

    /** Takes long on a small computer, so it is created only for the first machine. */
    private static final class Context {
        static final JAXBContext JAXB = create();

        private static JAXBContext create() {
            try {
                return JAXBContext.newInstance(AstahXml.Machine.class);
            } catch (JAXBException broken) {
                throw new IllegalStateException("the bindings of Astah's XMI are broken", broken);
            }
        }
    }

    static void prepare() {
        Objects.requireNonNull(Context.JAXB);
    }

    private AstahUnmarshaller(XmiStream stream) {
        super(stream);
        this.stream = stream;
    }

    /**
     * The contents of one state machine.
     *
     * @param problems elements without a binding, ids that are used twice, and references to unknown ids
     * @param definedIds the ids of the other elements
     * @param events the triggers, in the order of the file
     */
    record Result(AstahXml.Machine machine, Problems problems, Set<String> definedIds, List<AstahXml.Event> events) {}

    /** Reads the machine whose start tag is the current event; leaves the stream at the event after its end tag. */
    static Result unmarshal(XmiStream stream) {
        AstahUnmarshaller reader = new AstahUnmarshaller(stream);
        try {
            Unmarshaller unmarshaller = Context.JAXB.createUnmarshaller();
            unmarshaller.setListener(reader.new Watch());
            reader.visit();
            AstahXml.Machine machine =
                    unmarshaller.unmarshal(reader, AstahXml.Machine.class).getValue();
            reader.findDanglingReferences();
            return new Result(machine, reader.problems, reader.linesById.keySet(), reader.events);
        } catch (JAXBException broken) {
            throw stream.refuse("holds a state machine that JAXB cannot read, " + broken.getMessage(), "remove it");
        }
    }

    private final class Watch extends Unmarshaller.Listener {
        @Override
        public void beforeUnmarshal(Object target, @Nullable Object parent) {
            bound = true;
            AstahXml.Element element = (AstahXml.Element) target;
            element.line = stream.line();
            element.parent = open;
            open = element;
            stream.keep(stream.attribute("name").length());
        }

        @Override
        public void afterUnmarshal(Object target, @Nullable Object parent) {
            AstahXml.Element element = (AstahXml.Element) target;
            open = element.parent;
            if (element instanceof AstahXml.Event event) {
                events.add(event);
            }
            if (element.otherAttributes != null) {
                element.otherAttributes.forEach((name, value) ->
                        problems.add(element.line, "unknown attribute " + name + of(element) + "; remove it"));
                element.otherAttributes = null;
            }
        }
    }

    @Override
    public int next() {
        if (!bound) {
            passUnbound();
            bound = true;
            return END_ELEMENT;
        }
        int event = stream.next();
        if (open == null) {
            return event;
        }
        // JAXB would collect all text, even white space; no element of a machine has text.
        while (event != START_ELEMENT && event != END_ELEMENT) {
            if ((event == CHARACTERS || event == CDATA) && !stream.isWhiteSpace()) {
                problems.add(stream.line(), "text between the elements" + owner() + "; remove it");
            }
            event = stream.next();
        }
        if (event == START_ELEMENT) {
            bound = false;
            visit();
        }
        return event;
    }

    /** Advances to the end tag of an element without a binding. */
    private void passUnbound() {
        String name = stream.getLocalName();
        if (WITHOUT_MEANING.contains(name)) {
            stream.skipElement();
        } else if (REPEATED.contains(name)) {
            int depth = stream.depth();
            while (stream.nextElementWithin(depth)) {
                visit();
            }
        } else {
            refuseElement(AstahConstruct.of(name), name.indexOf('.') >= 0);
        }
    }

    /** @param role whether the element only contains the elements that have a name and an id */
    private void refuseElement(AstahConstruct construct, boolean role) {
        int depth = stream.depth();
        int before = problems.count();
        if (!role) {
            refuseStartTag(construct);
        }
        while (stream.nextElementWithin(depth)) {
            addRefusedId();
            if (role && stream.depth() == depth + 1) {
                refuseStartTag(construct);
            }
        }
        if (problems.count() == before) {
            problems.add(stream.line(), "empty " + construct.words() + owner() + "; remove it");
        }
    }

    private void refuseStartTag(AstahConstruct construct) {
        String id = addRefusedId();
        String name = AstahNames.decode(stream.attribute("name"));
        problems.add(
                stream.line(),
                construct.words() + " " + Problems.label(name, id) + owner() + " is not supported; "
                        + construct.remedy());
    }

    private String addRefusedId() {
        String id = stream.attribute("xmi.id");
        stream.keep(id.length());
        linesById.remove(id);
        refusedIds.add(id);
        return id;
    }

    /** Records the id and the reference of the current start tag. */
    private void visit() {
        String id = stream.attribute("xmi.id");
        if (!id.isEmpty()) {
            stream.keep(id.length());
            Integer earlier = linesById.putIfAbsent(id, stream.line());
            if (earlier != null) {
                problems.add(
                        stream.line(),
                        "id " + Problems.quote(id) + owner() + " is also the id of an element in line " + earlier
                                + "; give each its own");
            }
        }
        String idref = stream.attribute("xmi.idref");
        // Events and submachines may be defined outside the machine.
        if (!idref.isEmpty()
                && !stream.at(AstahXml.UML, "Event")
                && !(open instanceof AstahXml.Submachine)
                && references.putIfAbsent(idref, new Reference(stream.line(), open)) == null) {
            stream.keep(idref.length());
        }
        for (int i = 0; i < stream.getAttributeCount(); i++) {
            // JAXB interprets these attributes.
            if (XMLConstants.W3C_XML_SCHEMA_INSTANCE_NS_URI.equals(stream.getAttributeNamespace(i))) {
                problems.add(
                        stream.line(), "unknown attribute " + stream.getAttributeName(i) + owner() + "; remove it");
            }
        }
    }

    private void findDanglingReferences() {
        references.forEach((id, reference) -> {
            if (!linesById.containsKey(id) && !refusedIds.contains(id)) {
                problems.add(
                        reference.line(),
                        "reference to the unknown id " + Problems.quote(id) + of(reference.owner())
                                + "; export the model again, or correct the id");
            }
        });
    }

    private String owner() {
        return of(open);
    }

    /** {@code " of state 'On'"}: the nearest enclosing element that the author can see. */
    private static String of(AstahXml.@Nullable Element element) {
        for (AstahXml.Element near = element; near != null; near = near.parent) {
            if (!near.word().isEmpty() && !near.name().isEmpty()) {
                return " of " + near.word() + " " + Problems.quote(near.name());
            }
        }
        return "";
    }
}
