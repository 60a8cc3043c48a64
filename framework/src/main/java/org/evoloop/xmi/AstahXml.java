package org.evoloop.xmi;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAnyAttribute;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlElements;
import jakarta.xml.bind.annotation.XmlTransient;
import jakarta.xml.bind.annotation.adapters.XmlAdapter;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.xml.namespace.QName;
import org.jspecify.annotations.Nullable;

/**
 * JAXB bindings of the flat part of a state machine in Astah's XMI 1.1: UML 1.4, where an element such as {@code State}
 * holds role elements such as {@code StateVertex.outgoing}, which hold elements again.
 *
 * <p>Only what can be used is bound; {@link AstahUnmarshaller} finds the rest. Roles are lists even where UML allows one,
 * since of several JAXB would keep the last without a word.
 */
final class AstahXml {
    static final String UML = "org.omg.xmi.namespace.UML";

    private static final Pattern CONTROL_CHARACTERS = Pattern.compile("[\\p{Cc}\\u2028\\u2029]+");

    private AstahXml() {}

    /** A list that mostly holds one element or none. */
    private static <T> List<T> few() {
        return new ArrayList<>(0);
    }

    /**
     * The name as it was drawn: Astah writes the names of UML elements, not of diagrams, through {@code URLEncoder}. What
     * cannot be decoded was written by hand and stays.
     */
    static String decode(String written) {
        try {
            return tidy(URLDecoder.decode(written, StandardCharsets.UTF_8));
        } catch (IllegalArgumentException writtenByHand) {
            return tidy(written);
        }
    }

    /** One line without blanks around it: a line break, with the blanks around it, becomes one space. */
    static String tidy(String name) {
        return CONTROL_CHARACTERS
                .splitAsStream(name)
                .map(String::strip)
                .filter(line -> !line.isEmpty())
                .collect(Collectors.joining(" "));
    }

    /** For messages: name and id. */
    static String label(String name, String id) {
        return Problems.quote(name) + " (id " + Problems.quote(id) + ")";
    }

    /** Accepts an attribute whatever it says, and lets go of the text. */
    static final class WithoutMeaning extends XmlAdapter<String, String> {
        @Override
        public @Nullable String unmarshal(String text) {
            return null;
        }

        @Override
        public String marshal(String value) {
            return value;
        }
    }

    /** What every element has. */
    @XmlAccessorType(XmlAccessType.FIELD)
    abstract static class Element {
        @XmlAttribute(name = "xmi.id")
        @Nullable
        String id;

        @XmlAttribute(name = "xmi.idref")
        @Nullable
        String idref;

        @XmlAttribute(name = "name")
        @Nullable
        String writtenName;

        // Astah's own, without meaning in UML.
        @XmlAttribute
        @XmlJavaTypeAdapter(WithoutMeaning.class)
        @Nullable
        String version;

        @XmlAttribute
        @XmlJavaTypeAdapter(WithoutMeaning.class)
        @Nullable
        String unSolvedFlag;

        @XmlAnyAttribute
        @Nullable
        Map<QName, String> otherAttributes;

        @XmlTransient
        int line;

        @XmlTransient
        @Nullable
        Element parent;

        String id() {
            return id == null ? "" : id;
        }

        String idref() {
            return idref == null ? "" : idref;
        }

        /** Decoded, empty if there is none. */
        String name() {
            return writtenName == null ? "" : decode(writtenName);
        }

        /** For messages: name and id. */
        String label() {
            return AstahXml.label(name(), id());
        }

        /** How the author calls such an element; empty if its like is not seen in a diagram. */
        String word() {
            return "";
        }
    }

    /** {@code UML:StateMachine}. */
    static final class Machine extends Element {
        @XmlElement(name = "StateMachine.top")
        List<Top> tops = few();

        @XmlElement(name = "StateMachine.transitions")
        List<Transitions> transitions = few();
    }

    /** {@code UML:StateMachine.top}: one nameless state that holds the others. */
    static final class Top extends Element {
        @XmlElements({
            @XmlElement(name = "CompositeState", type = State.class),
            @XmlElement(name = "SimpleState", type = State.class)
        })
        List<State> states = few();
    }

    /** {@code UML:StateMachine.transitions}. */
    static final class Transitions extends Element {
        @XmlElement(name = "Transition")
        List<Transition> transitions = few();
    }

    /** What a transition may leave or enter. */
    abstract static class Vertex extends Element {}

    /** {@code UML:CompositeState}, which Astah writes for every state, or {@code UML:SimpleState}. */
    static final class State extends Vertex {
        // Always true in Astah's files, whatever was drawn.
        @XmlAttribute
        @XmlJavaTypeAdapter(WithoutMeaning.class)
        @Nullable
        String isConcurrent;

        @XmlAttribute
        @XmlJavaTypeAdapter(WithoutMeaning.class)
        @Nullable
        String isRegion;

        @XmlAttribute
        @Nullable
        String isOrthogonal;

        @XmlElement(name = "CompositeState.subvertex")
        List<Subvertices> subvertices = few();

        @Override
        String word() {
            return "state";
        }

        boolean orthogonal() {
            return isOrthogonal != null && !isOrthogonal.equals("false");
        }

        List<Vertex> substates() {
            return subvertices.stream().flatMap(role -> role.vertices.stream()).toList();
        }
    }

    /** {@code UML:CompositeState.subvertex}. */
    static final class Subvertices extends Element {
        @XmlElements({
            @XmlElement(name = "CompositeState", type = State.class),
            @XmlElement(name = "SimpleState", type = State.class),
            @XmlElement(name = "Pseudostate", type = Pseudostate.class)
        })
        List<Vertex> vertices = few();
    }

    /** {@code UML:Pseudostate}. */
    static final class Pseudostate extends Vertex {
        @XmlAttribute
        @Nullable
        String kind;

        @Override
        String word() {
            return "pseudostate";
        }

        boolean initial() {
            return "initial".equals(kind);
        }
    }

    /** {@code UML:Transition}; its name is its whole label, built by Astah from trigger, guard and effect. */
    static final class Transition extends Element {
        @XmlElement(name = "Transition.trigger")
        List<Trigger> triggers = few();

        @XmlElement(name = "Transition.source")
        List<End> sources = few();

        @XmlElement(name = "Transition.target")
        List<End> targets = few();

        @Override
        String word() {
            return "transition";
        }

        List<Event> events() {
            return triggers.stream().flatMap(role -> role.events.stream()).toList();
        }
    }

    /** {@code UML:Transition.trigger}. */
    static final class Trigger extends Element {
        @XmlElement(name = "Event")
        List<Event> events = few();
    }

    /** {@code UML:Event}: a definition of its own for each transition, or a reference. */
    static final class Event extends Element {}

    /** {@code UML:Transition.source} or {@code .target}. */
    static final class End extends Element {
        @XmlElement(name = "StateVertex")
        List<VertexReference> vertices = few();
    }

    /** {@code UML:StateVertex}: always the abstract name, whatever it refers to. */
    static final class VertexReference extends Element {}
}
