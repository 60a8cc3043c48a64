package org.evoloop.xmi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Enumeration;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.evoloop.statechart.Statechart;
import org.evoloop.statemachine.ModelException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Large and hostile documents of every dialect. */
class DialectBoundsTest {
    private static final String UML2 = "<uml:Model xmlns:uml='http://www.omg.org/spec/UML/20131001'"
            + " xmlns:xmi='http://www.omg.org/spec/XMI/20131001'>";
    private static final String UML2_MACHINE = "<packagedElement xmi:type='uml:StateMachine' xmi:id='m' name='M'>";
    private static final String UML14 = "<XMI xmi.version='1.2' xmlns:UML='org.omg.xmi.namespace.UML'><XMI.content>";
    private static final String SCXML = "<scxml xmlns='http://www.w3.org/2005/07/scxml'>";

    private static ModelFile read(Stream<String> parts) {
        Iterator<InputStream> bytes = parts.<InputStream>map(
                        part -> new ByteArrayInputStream(part.getBytes(StandardCharsets.UTF_8)))
                .iterator();
        return ModelFile.read("F.xml", new SequenceInputStream(new Enumeration<InputStream>() {
            @Override
            public boolean hasMoreElements() {
                return bytes.hasNext();
            }

            @Override
            public InputStream nextElement() {
                return bytes.next();
            }
        }));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                UML2 + UML2_MACHINE + "|<region>",
                UML14 + "<UML:StateMachine>|<UML:StateMachine.top>",
                SCXML + "|<state id='a'>",
            })
    void shouldRefuseDeepNesting(String document) {
        List<String> parts = List.of(document.split("\\|", -1));

        assertThatThrownBy(() -> read(Stream.concat(
                        Stream.of(parts.get(0)),
                        Stream.generate(() -> parts.get(1)).limit(1_000))))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith("F.xml: nests elements deeper than 500");
    }

    @Test
    void theParsersOwnLimitsWhichDifferBetweenJdksAreNotMet() {
        Map<String, String> limits = Map.of("jdk.xml.maxElementDepth", "100", "jdk.xml.elementAttributeLimit", "200");
        limits.forEach(System::setProperty);
        try {
            String attributes = IntStream.range(0, 1_000)
                    .mapToObj(each -> " x:a" + each + "=''")
                    .collect(Collectors.joining());
            String notes = "<x:note" + attributes + ">" + "<x:n>".repeat(450) + "</x:n>".repeat(450) + "</x:note>";
            assertThat(read(Stream.of(SCXML, "<state id='a' xmlns:x='urn:notes'>" + notes + "</state></scxml>"))
                            .machines())
                    .hasSize(1);
        } finally {
            limits.keySet().forEach(System::clearProperty);
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                UML2 + UML2_MACHINE + "<region>|<transition xmi:id='t' source='a' target='b'/>",
                UML14 + "<UML:StateMachine><UML:StateMachine.transitions>|<UML:Transition xmi.id='t' source='a'/>",
                SCXML + "|<state id='a'/>",
            })
    void shouldRefuseEndlesslyManyElements(String document) {
        List<String> parts = List.of(document.split("\\|", -1));
        String thousand = parts.get(1).repeat(1_000);

        assertThatThrownBy(() -> read(Stream.concat(
                        Stream.of(parts.get(0)), Stream.generate(() -> thousand).limit(5_000))))
                .isInstanceOf(ModelException.class)
                .hasMessageStartingWith("F.xml: its state machines are too large");
    }

    @ParameterizedTest
    @ValueSource(strings = {"uml:Model xmlns:uml='urn:uml'", "XMI xmi.version='1.2'", "scxml"})
    void shouldRefuseADoctype(String root) {
        assertThatThrownBy(() ->
                        read(Stream.of("<!DOCTYPE a [<!ENTITY b SYSTEM 'file:///etc/passwd'>]><" + root + ">&b;</x>")))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("contains a DOCTYPE, which is refused for security reasons");
    }

    @Test
    void shouldNotKeepTheDiagramsAroundAMachine() {
        String diagram = "<mdElement elementClass='x' xmi:id='d'>" + "<p>text</p>".repeat(1_000) + "</mdElement>";
        Stream<String> parts = Stream.of(
                        Stream.of(UML2 + UML2_MACHINE + "<region><subvertex xmi:type='uml:State' xmi:id='a' name='A'>"
                                + "<xmi:Extension>"),
                        // 2,000,000 elements, which would be too many to keep.
                        Stream.generate(() -> diagram).limit(1_000),
                        Stream.of("</xmi:Extension></subvertex></region></packagedElement>"),
                        Stream.generate(() -> diagram).limit(1_000),
                        Stream.of("</uml:Model>"))
                .flatMap(part -> part);

        assertThat(ChartText.of(read(parts).machines().get(0).statechart())).containsExactly("state a A");
    }

    @Test
    void shouldReadAHundredThousandTransitions() {
        int states = 1_000;
        Stream<String> vertices = IntStream.range(0, states)
                .mapToObj(i -> "<subvertex xmi:type='uml:State' xmi:id='_s" + i + "' name='S" + i + "'/>");
        Stream<String> transitions = IntStream.range(0, 100_000)
                .mapToObj(i -> "<transition xmi:type='uml:Transition' xmi:id='_transition" + i + "' source='_s"
                        + i % states + "' target='_s" + (i * 7) % states
                        + "'><trigger xmi:type='uml:Trigger' xmi:id='_trigger" + i + "' event='_e'/></transition>");
        Statechart chart = read(Stream.of(
                                Stream.of(UML2 + UML2_MACHINE + "<region>"),
                                vertices,
                                transitions,
                                Stream.of(
                                        "</region></packagedElement>"
                                                + "<packagedElement xmi:type='uml:SignalEvent' xmi:id='_e' name='e'/></uml:Model>"))
                        .flatMap(part -> part))
                .machines()
                .get(0)
                .statechart();

        assertThat(chart.regions().get(0).arcs()).hasSize(100_000);
    }
}
