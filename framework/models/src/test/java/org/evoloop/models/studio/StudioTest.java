package org.evoloop.models.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import org.evoloop.studio.Analysis;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;

/** The studio's answers, over HTTP. */
class StudioTest extends StudioRequests {
    @Test
    void foreignPagesAndClientsWithoutTheTokenAreRefused() throws Exception {
        assertThat(send("POST", "/api/draw", "{}", "http://example.org").statusCode())
                .isEqualTo(403);
        cookie = "";
        assertThat(send("POST", "/api/draw", "{}", origin).statusCode()).isEqualTo(401);
        assertThat(send("GET", "/api/files", "", origin).statusCode()).isEqualTo(401);
        assertThat(send("GET", "/", "", origin).statusCode()).isEqualTo(200);
    }

    @Test
    void aRequestThatIsTooLargeOrMakesNoSenseIsAnswered() throws Exception {
        ask(400, "POST", "/api/draw", Map.of());
        ask(400, "POST", "/api/draw", Map.of("pair", pair(), "view", "sideways"));
        assertThat(send("POST", "/api/draw", "[", origin).statusCode()).isEqualTo(400);
        ask(404, "POST", "/api/nothing", Map.of());
        assertThat(send("POST", "/api/draw", " ".repeat((4 << 20) + 1), origin).statusCode())
                .isEqualTo(413);
    }

    @Test
    void whatFailsIsAnsweredInWordsAndTheStudioGoesOn() throws Exception {
        close();
        Iterator<Error> errors = List.of(
                        new StackOverflowError(), new AssertionError("no"), new ExceptionInInitializerError("x"))
                .iterator();
        begin((Analysis) Proxy.newProxyInstance(
                Analysis.class.getClassLoader(), new Class<?>[] {Analysis.class}, (proxy, method, arguments) -> {
                    throw errors.next();
                }));
        assertThat(send("POST", "/api/draw", JSON.writeValueAsString(Map.of("pair", pair())), origin)
                        .body())
                .isEqualTo("{\"error\":\"the models are too large for this\"}");
        while (errors.hasNext()) {
            HttpResponse<String> answer =
                    send("POST", "/api/draw", JSON.writeValueAsString(Map.of("pair", pair())), origin);
            assertThat(answer.statusCode()).isEqualTo(500);
            assertThat(answer.body()).contains("the program has failed at this");
        }
        ask(200, "GET", "/api/files", "");
    }

    @Test
    void bothModelsAreDrawnWithWhatIsAddedAndRerouted() throws Exception {
        JsonNode drawn = post("/api/draw", Map.of("pair", pair(), "direction", "down"));
        JsonNode evolved = drawn.path("new");
        assertThat(evolved.path("svg").asString())
                .contains("data-state=\"warm\"", "data-line=\"19\"", "class=\"state added\"")
                .doesNotContain("<style>", "#333");
        assertThat(all(evolved.path("states"), "tone")).containsExactly("", "", "added", "added");
        assertThat(all(evolved.path("transitions"), "tone"))
                .containsExactly("", "", "rerouted", "added", "added", "added");
        assertThat(evolved.path("transitions").path(2).path("line").asInt()).isEqualTo(18);
        assertThat(all(drawn.path("original").path("states"), "name")).containsExactly("off", "on");
    }

    @ParameterizedTest
    @ValueSource(strings = {"down", "right"})
    void aPictureDoesNotTurnWhileOneTypes(String direction) throws Exception {
        String text = LAMP;
        for (int i = 0; i < 6; i++) {
            text = text.replace(
                    "    warm --> off : switch\n", "    warm --> off : switch\n    warm --> s" + i + " : e" + i + "\n");
            String svg = post("/api/draw", Map.of("pair", pair(text), "direction", direction))
                    .path("new")
                    .path("svg")
                    .asString();
            double[] off = place(svg, "off");
            double[] warm = place(svg, "warm");
            boolean isDown = warm[1] - off[1] > Math.abs(warm[0] - off[0]);
            assertThat(isDown).isEqualTo(direction.equals("down"));
        }
    }

    private static double[] place(String svg, String state) {
        String[] box = svg.replaceFirst(
                        "(?s).*data-state=\"" + state + "\"[^>]*>\\s*<rect[^>]* x=\"([0-9.]+)\" y=\"([0-9.]+)\".*",
                        "$1 $2")
                .split(" ", -1);
        return new double[] {Double.parseDouble(box[0]), Double.parseDouble(box[1])};
    }

    @Test
    void aHalfTypedTextGivesTheMistakeAndItsLine() throws Exception {
        JsonNode drawn = post("/api/draw", Map.of("pair", pair(LAMP.replace("on --> wait : switch", "on -> wai"))));
        assertThat(drawn.path("new").path("mistake").path("line").asInt()).isEqualTo(18);
        assertThat(drawn.path("new").path("mistake").path("message").asString()).contains("-->");
        assertThat(drawn.path("original").has("svg")).isTrue();
        JsonNode findings = post("/api/check", Map.of("pair", pair(LAMP.replace("on --> wait : switch", "on -> wai"))))
                .path("findings");
        assertThat(findings.path(0).path("line").asInt()).isEqualTo(18);
    }

    @Test
    void ofSeveralProblemsTheFirstIsSaidOnItsLine() throws Exception {
        String text = LAMP.replace("    warm --> off : switch\n", "    warm -> off\n    warm => off\n");
        JsonNode mistake =
                post("/api/draw", Map.of("pair", pair(text))).path("new").path("mistake");
        assertThat(mistake.path("line").asInt()).isEqualTo(21);
        assertThat(mistake.path("message").asString()).contains("-->").doesNotContain("problems");
        JsonNode findings = post("/api/check", Map.of("pair", pair(text))).path("findings");
        assertThat(findings.valueStream().map(each -> each.path("line").asInt()))
                .containsExactly(21, 22);
    }

    @Test
    void theOverviewClosesStatesAndAStateHasItsSurroundings() throws Exception {
        String text =
                "stateDiagram-v2\n [*] --> A\n state A {\n  [*] --> In\n  In --> In2 : e\n }\n A --> B : f\n A --> B : g\n B --> C : h\n";
        Files.writeString(
                folder.resolve("lamp.md"),
                text.transform(t -> "```mermaid\n---\ntitle: original\n---\n" + t
                        + "```\n```mermaid\n---\ntitle: new\n---\n" + t + "```\n"));
        String overview = post("/api/draw", Map.of("pair", pair(), "view", "overview"))
                .path("new")
                .path("svg")
                .asString();
        assertThat(overview).doesNotContain("data-state=\"In\"").contains("data-event=\"f g\"", ">f, g<");
        String around = post("/api/draw", Map.of("pair", pair(), "view", "around", "around", "In"))
                .path("new")
                .path("svg")
                .asString();
        assertThat(around)
                .contains("data-state=\"A\"", "data-state=\"B\"", "data-event=\"e\"")
                .doesNotContain("data-state=\"C\"");
    }

    @Test
    void findingsHaveTheirLineAndARunThatShowsThem() throws Exception {
        String trap = LAMP.replace("    warm --> off : switch\n", "");
        JsonNode found = post("/api/check", Map.of("pair", pair(trap), "properties", "Off: always can off\n"))
                .path("findings");
        assertThat(all(found, "rule")).contains("trap-state", "property");
        JsonNode property = found.valueStream()
                .filter(each -> each.path("rule").asString().equals("property"))
                .findFirst()
                .orElseThrow();
        assertThat(property.path("run").toString())
                .isEqualTo("[{\"press\":\"switch\"},{\"press\":\"switch\"},{\"press\":\"switch\"}]");
        JsonNode state = found.valueStream()
                .filter(each -> each.path("rule").asString().equals("trap-state"))
                .findFirst()
                .orElseThrow();
        assertThat(state.path("line").asInt()).isEqualTo(20);
        assertThat(state.path("state").asString()).isEqualTo("warm");
        JsonNode unclear = post("/api/check", Map.of("pair", pair(), "properties", "\nOff: always kann off\n"))
                .path("findings");
        assertThat(unclear.path(0).path("line").asInt()).isEqualTo(2);
    }

    @Test
    void thePlanOfATransitionNamesThoseOfTheDevice() throws Exception {
        JsonNode plan = post("/api/plan", Map.of("pair", pair(), "state", "wait", "event", "tm(2s)"));
        assertThat(plan.path("words").asString()).isEqualTo("path switch (on --switch--> off)");
        assertThat(plan.path("steps").path(0).path("id").asString()).isEqualTo("t9");
        assertThat(post("/api/plan", Map.of("pair", pair(), "state", "on", "event", "switch"))
                        .path("function")
                        .asString())
                .isEqualTo("wait");
    }

    @Test
    void anEditComesBackAsText() throws Exception {
        JsonNode edited = post(
                "/api/edit",
                Map.of(
                        "path", "lamp.md",
                        "text", LAMP,
                        "machine", "original",
                        "other", "new",
                        "edit", Map.of("kind", "rename-state", "from", "on", "to", "bright")));
        assertThat(edited.path("text").asString())
                .contains("    off --> bright : switch\n    bright --> off : switch", "bright --> wait")
                .doesNotContain("on :", " on ");
        JsonNode refused = ask(
                422,
                "POST",
                "/api/edit",
                Map.of(
                        "path",
                        "lamp.md",
                        "text",
                        LAMP,
                        "machine",
                        "new",
                        "edit",
                        Map.of("kind", "add-state", "name", "on")));
        assertThat(refused.path("refused").asString()).contains("already");
        for (String dialect : List.of("mermaid", "markdown", "plantuml", "scxml")) {
            assertThat(post("/api/edit", Map.of("path", "x", "edit", Map.of("kind", "new-file", "dialect", dialect)))
                            .path("text")
                            .asString())
                    .contains("Off");
        }
    }

    @Test
    void aRunIsPlayedByTheCoreAndItsDevice() throws Exception {
        JsonNode tried = post(
                "/api/try",
                Map.of("pair", pair(), "run", List.of(Map.of("press", "switch"), Map.of("press", "switch"))));
        assertThat(tried.path("states").toString()).isEqualTo("{\"original\":\"on\",\"new\":\"wait\"}");
        assertThat(all(tried.path("possible"), "press")).contains("switch");
        assertThat(all(tried.path("possible"), "after")).contains("2000 ms");
        JsonNode later = post(
                "/api/try",
                Map.of(
                        "pair",
                        pair(),
                        "run",
                        List.of(Map.of("press", "switch"), Map.of("press", "switch"), Map.of("after", "2 s"))));
        assertThat(later.path("states").toString()).isEqualTo("{\"original\":\"off\",\"new\":\"off\"}");
        assertThat(later.path("steps").path(2).path("sent").toString()).isEqualTo("[\"switch\"]");
        assertThat(later.path("time").asString()).isEqualTo("2000 ms");
        ask(400, "POST", "/api/try", Map.of("pair", pair(), "run", List.of(Map.of("after", "9999 h"))));
    }

    @Test
    void whatTheDeviceMayDoLeadsWhereTheTrialSays() throws Exception {
        String original = """
                stateDiagram-v2
                    [*] --> Closed
                    Closed --> Opening : open
                    Opening --> Open : «spontaneous» opened
                    Opening --> Closed : «spontaneous» blocked
                    Open --> Closed : close
                """;
        String evolved = original.replace("«spontaneous» ", "") + """
                    Closed --> Airing : air
                    Airing : «device Opening»
                    Airing --> Closed : blocked
                """;
        Map<String, Object> models = Map.of(
                "original", Map.of("path", "a.mmd"),
                "new", Map.of("path", "b.mmd"),
                "texts", Map.of("a.mmd", original, "b.mmd", evolved));
        List<Map<String, String>> run = List.of(Map.of("press", "air"));
        JsonNode airing = post("/api/try", Map.of("pair", models, "run", run));
        assertThat(airing.path("states").path("new").asString()).isEqualTo("Airing");
        assertThat(all(airing.path("possible"), "device")).contains("opened", "blocked");
        for (JsonNode next : airing.path("possible")) {
            if (next.has("device")) {
                List<Map<String, String>> longer =
                        List.of(run.get(0), Map.of("device", next.path("device").asString()));
                assertThat(post("/api/try", Map.of("pair", models, "run", longer))
                                .path("states")
                                .path("new")
                                .asString())
                        .as(next.toString())
                        .isEqualTo(next.path("target").asString());
            }
        }
    }

    @Test
    void aRunIsAScenarioOfADeviceFile() throws Exception {
        List<Map<String, String>> run =
                List.of(Map.of("press", "switch"), Map.of("press", "switch"), Map.of("after", "2 s"));
        String yaml = post("/api/scenario", Map.of("pair", pair(), "run", run, "title", "a short press: off"))
                .path("yaml")
                .asString();
        String file = """
                converter: lamp
                models:
                  original: lamp.md#original
                  new: lamp.md#new
                connections:
                  lamp:
                    lines: "tcp://localhost:5000"
                device:
                  send: {switch: S}
                functions:
                  warm: {}
                scenarios:
                """;
        assertThat(post("/api/device", Map.of("path", "lamp.yaml", "text", file + yaml))
                        .path("problems")
                        .toString())
                .isEqualTo("[]");
        JsonNode wrong = post(
                        "/api/device",
                        Map.of("path", "lamp.yaml", "text", file + yaml.replace("state: wait", "state: warm")))
                .path("problems");
        assertThat(wrong.path(0).path("message").asString()).contains("state is wait");
        assertThat(post(
                                "/api/device",
                                Map.of(
                                        "path",
                                        "lamp.yaml",
                                        "text",
                                        file.replace("lamp.md#new", "../../etc/passwd#new")))
                        .path("problems")
                        .toString())
                .isEqualTo("[{\"line\":4,\"message\":\"'../../etc/passwd#new' is outside of the folder that the studio"
                        + " shows; start it there\"}]");
        JsonNode misspelt = post(
                        "/api/device",
                        Map.of(
                                "path",
                                "lamp.yaml",
                                "text",
                                file.replace("switch: S", "swich: S"),
                                "texts",
                                Map.of("lamp.md", LAMP)))
                .path("problems");
        assertThat(misspelt.path(0).path("line").asInt()).isEqualTo(9);
    }

    @Test
    void aPropertyHoldsOrIsPlayed() throws Exception {
        assertThat(post("/api/property", Map.of("pair", pair(), "property", "always can off"))
                        .path("holds")
                        .asBoolean())
                .isTrue();
        JsonNode fails = post("/api/property", Map.of("pair", pair(), "property", "never wait"));
        assertThat(fails.path("holds").asBoolean()).isFalse();
        assertThat(fails.path("run")).hasSize(2);
        assertThat(post("/api/property", Map.of("pair", pair(), "property", "quick: wait never longer than 2 s"))
                        .path("holds")
                        .asBoolean())
                .isTrue();
        ask(400, "POST", "/api/property", Map.of("pair", pair(), "property", "whatever"));
    }

    @Test
    void aTableShowsWhatBecomesOfTheSavedModelsInTheUnsavedOnes() throws Exception {
        JsonNode table =
                post("/api/converters/lamp", Map.of("command", "migrate", "pair", pair(LAMP.replace("warm", "cosy"))));
        assertThat(table.path("words").asString()).contains("(on, wait)  maps to (on, wait)");
        assertThat(table.path("table").isObject()).isTrue();
    }

    @Test
    void aConverterThatDoesNotRunIsSaid() throws Exception {
        assertThat(ask(200, "GET", "/api/converters", "").has("names")).isTrue();
        assertThat(ask(422, "POST", "/api/converters/nobody-here", Map.of("command", "rollback"))
                        .path("error")
                        .asString())
                .contains("no instance named nobody-here");
    }

    @Test
    void aModelTooLargeForAPictureIsSaidAtOnce() throws Exception {
        StringBuilder text = new StringBuilder("```mermaid\n---\ntitle: original\n---\nstateDiagram-v2\n[*] --> s0\n");
        for (int i = 0; i < 700; i++) {
            text.append("s")
                    .append(i)
                    .append(" --> s")
                    .append((i * 7 + 1) % 700)
                    .append(" : e")
                    .append(i % 30)
                    .append('\n');
        }
        String large = text + "```\n" + text.toString().replace("original", "new") + "```\n";
        JsonNode drawn = post("/api/draw", Map.of("pair", pair(large)));
        assertThat(drawn.path("new").path("tooLarge").asString()).contains("too many");
        assertThat(drawn.path("new").path("states")).hasSize(700);
    }
}
