package org.evoloop.xmi.astah;

import jakarta.xml.bind.annotation.XmlAccessType;
import jakarta.xml.bind.annotation.XmlAccessorType;
import jakarta.xml.bind.annotation.XmlAnyAttribute;
import jakarta.xml.bind.annotation.XmlAttribute;
import jakarta.xml.bind.annotation.XmlElement;
import jakarta.xml.bind.annotation.XmlElements;
import jakarta.xml.bind.annotation.XmlTransient;
import jakarta.xml.bind.annotation.adapters.XmlAdapter;
import jakarta.xml.bind.annotation.adapters.XmlJavaTypeAdapter;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import javax.xml.namespace.QName;
import org.evoloop.xmi.dialect.Problems;
import org.jspecify.annotations.Nullable;

/**
 * JAXB bindings of a state machine in Astah's XMI 1.1 of UML 1.4. There, an element such as {@code State} contains role
 * elements such as {@code StateVertex.outgoing}, which contain elements again.
 *
 * <p>Only supported constructs have bindings; {@link AstahUnmarshaller} finds the rest. Roles are lists even where UML
 * allows only one, since JAXB would silently keep the last of several.
 */
final class AstahXml {
    static final String UML = "org.omg.xmi.namespace.UML";

    private AstahXml() {}

    /** A list that mostly has one element or none. */
    private static <T> List<T> few() {
        return new ArrayList<>(0);
    }

    /** Accepts an attribute with any value, and discards the value. */
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

    /** The attributes of every element. */
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

        // Astah's own attribute, without meaning in UML.
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

        /** The decoded name; empty if there is none. */
        String name() {
            return writtenName == null ? "" : AstahNames.decode(writtenName);
        }

        /** For messages: name and id. */
        String label() {
            return Problems.label(name(), id());
        }

        /** The author's term for such an element; empty if it is not visible in a diagram. */
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

        List<Transition> allTransitions() {
            return transitions.stream()
                    .flatMap(role -> role.transitions.stream())
                    .toList();
        }
    }

    /** {@code UML:StateMachine.top}: one nameless state that contains the others. */
    static final class Top extends Element {
        @XmlElements({
            @XmlElement(name = "CompositeState", type = State.class),
            @XmlElement(name = "SimpleState", type = State.class)
        })
        List<State> states = few();
    }

    /** {@code UML:StateMachine.transitions} or {@code UML:State.internalTransition}. */
    static final class Transitions extends Element {
        @XmlElement(name = "Transition")
        List<Transition> transitions = few();
    }

    /** A possible source or target of a transition. */
    abstract static class Vertex extends Element {}

    /** {@code UML:CompositeState}, which Astah writes for every state, or {@code UML:SimpleState}. */
    static class State extends Vertex {
        // Always true in Astah's files, whatever is drawn.
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

        @XmlElement(name = "State.entry")
        List<Actions> entries = few();

        @XmlElement(name = "State.exit")
        List<Actions> exits = few();

        @XmlElement(name = "State.doActivity")
        List<Actions> doActivities = few();

        @XmlElement(name = "State.internalTransition")
        List<Transitions> internals = few();

        @XmlElement(name = "State.deferrableEvent")
        List<Events> deferrable = few();

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

        List<Transition> internalTransitions() {
            return internals.stream().flatMap(role -> role.transitions.stream()).toList();
        }
    }

    /** {@code UML:SubmachineState}. */
    static final class SubmachineState extends State {
        @XmlElement(name = "SubmachineState.submachine")
        List<Submachine> submachines = few();

        @Override
        String word() {
            return "submachine state";
        }
    }

    /** {@code UML:SubmachineState.submachine}. */
    static final class Submachine extends Element {
        @XmlElement(name = "StateMachine")
        List<MachineReference> machines = few();
    }

    /** {@code UML:StateMachine} with an {@code xmi.idref}. */
    static final class MachineReference extends Element {}

    /** {@code UML:StubState}: inside a submachine state, refers to the submachine's state of the same name. */
    static final class StubState extends Vertex {
        @XmlAttribute
        @Nullable
        String referenceState;

        @Override
        String word() {
            return "stub state";
        }

        /** The name of the state that it refers to. */
        String reference() {
            return referenceState == null || referenceState.isBlank() ? name() : AstahNames.decode(referenceState);
        }
    }

    /** {@code UML:FinalState}. */
    static final class FinalState extends Vertex {
        @Override
        String word() {
            return "final state";
        }
    }

    /** {@code UML:CompositeState.subvertex}. */
    static final class Subvertices extends Element {
        @XmlElements({
            @XmlElement(name = "CompositeState", type = State.class),
            @XmlElement(name = "SimpleState", type = State.class),
            @XmlElement(name = "SubmachineState", type = SubmachineState.class),
            @XmlElement(name = "StubState", type = StubState.class),
            @XmlElement(name = "FinalState", type = FinalState.class),
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
    }

    /** {@code UML:Transition}; its name is its whole label, which Astah builds from trigger, guard and effect. */
    static final class Transition extends Element {
        @XmlElement(name = "Transition.trigger")
        List<Events> triggers = few();

        @XmlElement(name = "Transition.guard")
        List<Guards> guards = few();

        @XmlElement(name = "Transition.effect")
        List<Actions> effects = few();

        @XmlElement(name = "Transition.source")
        List<End> sources = few();

        @XmlElement(name = "Transition.target")
        List<End> targets = few();

        @Override
        String word() {
            return "transition";
        }
    }

    /** {@code UML:Transition.trigger} or {@code UML:State.deferrableEvent}. */
    static final class Events extends Element {
        @XmlElement(name = "Event")
        List<Event> events = few();
    }

    /** {@code UML:Event}: a separate definition for each transition, or a reference. */
    static final class Event extends Element {}

    /** {@code UML:Transition.guard}. */
    static final class Guards extends Element {
        @XmlElement(name = "Guard")
        List<Guard> guards = few();
    }

    /** {@code UML:Guard}: its name is the condition. */
    static final class Guard extends Element {}

    /** {@code UML:State.entry}, {@code .exit}, {@code .doActivity} or {@code UML:Transition.effect}. */
    static final class Actions extends Element {
        @XmlElement(name = "Action")
        List<Action> actions = few();
    }

    /** {@code UML:Action}: its name is the action's text. */
    static final class Action extends Element {
        // Has the same value in all of Astah's files.
        @XmlAttribute
        @XmlJavaTypeAdapter(WithoutMeaning.class)
        @Nullable
        String isAsynchronous;

        @XmlAttribute
        @XmlJavaTypeAdapter(WithoutMeaning.class)
        @Nullable
        String actionType;
    }

    /** {@code UML:Transition.source} or {@code .target}. */
    static final class End extends Element {
        @XmlElement(name = "StateVertex")
        List<VertexReference> vertices = few();
    }

    /** {@code UML:StateVertex}: always this abstract name, whatever it refers to. */
    static final class VertexReference extends Element {}
}
