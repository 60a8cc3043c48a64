package org.evoloop.models.studio;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.chart.ArcLabel;
import org.evoloop.models.chart.ChartIndex;
import org.evoloop.models.diagram.Around;
import org.evoloop.models.diagram.ChartDiagram;
import org.evoloop.models.diagram.Diagram;
import org.evoloop.models.diagram.Diagram.Edge;
import org.evoloop.models.diagram.Layouts;
import org.evoloop.models.diagram.Overview;
import org.evoloop.models.diagram.SvgWriter;
import org.evoloop.payload.JsonObject;
import org.evoloop.statechart.Arc;
import org.evoloop.statechart.EventKeywords;
import org.evoloop.statechart.Vertex;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.studio.Analysis.Detail;
import org.evoloop.studio.Analysis.Direction;
import org.evoloop.studio.Analysis.View;
import org.evoloop.studio.MistakeException;
import org.evoloop.studio.Pair;
import org.evoloop.studio.Source;
import org.jspecify.annotations.Nullable;

/** Both models of a request as pictures, with what their author wants to find in them. */
final class Pictures {
    /** A picture of more states and transitions takes too long while one types. */
    static final int MOST_ELEMENTS = 600;

    private final View view;
    private final Layouts layouts;

    private Pictures(View view, Layouts layouts) {
        this.view = view;
        this.layouts = layouts;
    }

    static JsonObject draw(Pair pair, View view, Layouts layouts) {
        JsonObject answer = new JsonObject();
        Shown original = read(pair.original(), "original", answer);
        Shown evolved = read(pair.evolved(), "new", answer);
        Tones tones = original == null || evolved == null ? Tones.NONE : tones(original, evolved);
        Pictures pictures = new Pictures(view, layouts);
        if (original != null) {
            answer.put("original", pictures.picture("original", original, tones));
        }
        if (evolved != null) {
            answer.put("new", pictures.picture("new", evolved, tones));
        }
        return answer;
    }

    private static @Nullable Shown read(Source source, String side, JsonObject answer) {
        try {
            return Shown.of(source);
        } catch (MistakeException mistaken) {
            answer.put(side, new JsonObject().put("mistake", mistaken.mistake().json()));
            return null;
        }
    }

    private static Tones tones(Shown original, Shown evolved) {
        return original.flat()
                .flatMap(device -> evolved.flat().map(system -> new ModelPair(device, system)))
                .map(pair -> Tones.of(pair, original.drawing(), evolved.drawing()))
                .orElse(Tones.NONE);
    }

    private JsonObject picture(String side, Shown shown, Tones tones) {
        ChartIndex index = shown.index();
        JsonObject answer = new JsonObject()
                .put("name", shown.chart().name())
                .put("path", shown.source().path())
                .put("line", shown.source().machine().line());
        Diagram wanted = wanted(shown, tones);
        int elements = view.detail() == Detail.ALL
                ? shown.elements()
                : wanted.nodes().size() + wanted.edges().size();
        if (elements > MOST_ELEMENTS) {
            answer.put("tooLarge", elements + " states and transitions are too many for a picture; " + instead());
        } else {
            answer.put("svg", SvgWriter.plain(side, wanted, view.direction() == Direction.DOWN, layouts));
        }
        List<JsonObject> states = new ArrayList<>();
        for (ChartState state : index.states()) {
            states.add(new JsonObject()
                    .put("name", index.name(state.key()))
                    .put("line", state.place().line())
                    .put("tone", Tones.word(tones.of(state)))
                    .put("parent", index.parent(state.key()))
                    .put("device", state.use().device()));
        }
        List<JsonObject> transitions = new ArrayList<>();
        for (Arc arc : index.arcs()) {
            transitions.add(new JsonObject()
                    .put("id", shown.id(arc))
                    .put("source", index.name(arc.source()))
                    .put("event", String.join(", ", arc.triggers()))
                    .put("trigger", ArcLabel.triggers(arc))
                    .put("guard", arc.guard())
                    .putTexts("effects", arc.effects())
                    .put("target", index.name(arc.target()))
                    .put("line", arc.place().line())
                    .put("tone", Tones.word(tones.of(arc)))
                    .put("initial", ChartIndex.isInitial(index.vertex(arc.source()))));
        }
        return answer.put("states", states).put("transitions", transitions);
    }

    private String instead() {
        return switch (view.detail()) {
            case ALL -> "look at the overview, or around a state";
            case OVERVIEW -> "look around a state";
            case AROUND -> "put the cursor in the line of a state or an arrow, to look around it";
        };
    }

    private Diagram wanted(Shown shown, Tones tones) {
        Diagram all = withoutKeyword(ChartDiagram.of(shown.chart(), tones::of, tones::of, new Facts(shown)));
        return switch (view.detail()) {
            case ALL -> all;
            case OVERVIEW -> Overview.of(all);
            case AROUND -> key(shown).map(key -> Around.of(all, key)).orElseGet(() -> Overview.of(all));
        };
    }

    /** What the device does itself has another look, which is shorter than the keyword on each arrow. */
    private static Diagram withoutKeyword(Diagram all) {
        String keyword = EventKeywords.before(true, false);
        List<Edge> edges = all.edges().stream()
                .map(edge -> new Edge(
                        edge.source(), edge.target(), edge.label().replace(keyword, ""), edge.tone(), edge.data()))
                .toList();
        return new Diagram(all.title(), all.nodes(), edges);
    }

    private Optional<String> key(Shown shown) {
        return shown.index().states().stream()
                .map(ChartState::key)
                .filter(key -> shown.index().name(key).equals(view.around()))
                .findFirst();
    }

    /** What the page wants to know of the elements of a picture. */
    private record Facts(Shown shown) implements ChartDiagram.Data {
        @Override
        public Map<String, String> of(Vertex vertex) {
            Map<String, String> data = new LinkedHashMap<>();
            if (vertex instanceof ChartState) {
                data.put("state", shown.index().name(vertex.key()));
            }
            data.put("line", String.valueOf(vertex.place().line()));
            return data;
        }

        @Override
        public Map<String, String> of(Arc arc) {
            Map<String, String> data = new LinkedHashMap<>();
            data.put("id", shown.id(arc));
            data.put("source", shown.index().name(arc.source()));
            data.put("target", shown.index().name(arc.target()));
            data.put("event", String.join(", ", arc.triggers()));
            data.put("line", String.valueOf(arc.place().line()));
            if (!arc.spontaneous().isEmpty()) {
                data.put("own", "true");
            }
            return data;
        }
    }
}
