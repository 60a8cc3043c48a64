package org.evoloop.program.prometheus;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.evoloop.LightBulb;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.console.Console;
import org.evoloop.converter.DeviceLink;
import org.evoloop.function.Reading;
import org.evoloop.loop.LoopConfig;
import org.evoloop.page.Page;
import org.evoloop.page.PageOptions;
import org.evoloop.testkit.ConverterHarness;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What Prometheus gets from the page of the paper's light bulb. */
@Timeout(60)
class PrometheusDocumentTest {
    private final ConverterHarness lamp = lamp("lamp");
    private final ConverterHarness other = lamp("other \"lamp\"");
    private final Cable cable = new Cable();
    private final ByteArrayOutputStream announced = new ByteArrayOutputStream();
    private Page page;

    private static ConverterHarness lamp(String name) {
        LightBulb warm = new LightBulb(
                PaperModels.lightBulb(),
                Duration.ofSeconds(2),
                visit -> visit.progress("warming up", List.of(Reading.of("warmth", 0.5, ""))));
        return ConverterHarness.of(warm)
                .with(new RecordingExecute("Lamp", "switch"))
                .options(config -> LoopConfig.defaults(name, config.clock()))
                .start();
    }

    private static final class Cable implements DeviceLink {
        private volatile boolean up = true;

        @Override
        public boolean isUp() {
            return up;
        }

        @Override
        public List<Reading> readings() {
            return List.of(Reading.of("battery", 93, "%"), Reading.of("docked", true), Reading.of("mode", "safe"));
        }

        @Override
        public String describe() {
            return "a cable";
        }
    }

    @BeforeEach
    void open() throws IOException {
        lamp.converter().addLink(cable);
        other.converter().stop();
        Console console = new Console(lamp.converter(), InputStream.nullInputStream(), System.out, System.err);
        console.addConverter(other.converter());
        page = Page.open(PageOptions.at("0"), console, new PrintStream(announced, true, StandardCharsets.UTF_8));
    }

    @AfterEach
    void close() {
        page.close();
        lamp.close();
        other.close();
    }

    private HttpResponse<String> get(String path) throws IOException, InterruptedException {
        String address = announced.toString(StandardCharsets.UTF_8).replaceFirst("(?s)page: (\\S+)/ to look.*", "$1");
        return HttpClient.newHttpClient()
                .send(HttpRequest.newBuilder(URI.create(address + path)).build(), HttpResponse.BodyHandlers.ofString());
    }

    private Map<String, Double> scrape() throws IOException, InterruptedException {
        HttpResponse<String> answer = get("/metrics");
        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(answer.headers().firstValue("Content-Type")).contains("text/plain; version=0.0.4; charset=utf-8");
        return Scrape.read(answer.body());
    }

    @Test
    void eventsQueueAndStatesAreExported() throws Exception {
        lamp.press("switch");

        assertThat(scrape())
                .containsEntry("evoloop_events_total{converter=\"lamp\",outcome=\"handled\"}", 1.0)
                .containsEntry("evoloop_events_total{converter=\"lamp\",outcome=\"dropped\"}", 0.0)
                .containsEntry("evoloop_events_total{converter=\"other \\\"lamp\\\"\",outcome=\"handled\"}", 0.0)
                .containsEntry("evoloop_queue_capacity{converter=\"lamp\"}", 8.0)
                .containsEntry("evoloop_running{converter=\"lamp\"}", 1.0)
                .containsEntry("evoloop_running{converter=\"other \\\"lamp\\\"\"}", 0.0)
                .containsEntry("evoloop_failures{component=\"Lamp\",converter=\"lamp\"}", 0.0)
                .containsKey("jvm_threads_live_threads");

        lamp.press("switch");
        assertThat(scrape()).containsEntry("evoloop_events_total{converter=\"lamp\",outcome=\"handled\"}", 2.0);
    }

    @Test
    void conversionTimesAreAHistogramFromTheFirstQuestionOn() throws Exception {
        scrape();
        lamp.press("switch").press("switch");

        assertThat(get("/metrics").body()).contains("# TYPE evoloop_conversion_time_seconds histogram");
        Map<String, Double> samples = scrape();
        assertThat(samples)
                .containsEntry("evoloop_conversion_time_seconds_count{converter=\"lamp\"}", 2.0)
                .containsEntry("evoloop_conversion_time_seconds_sum{converter=\"lamp\"}", 0.0)
                .containsEntry("evoloop_conversion_time_seconds_bucket{converter=\"lamp\",le=\"5.0E-5\"}", 2.0)
                .containsEntry("evoloop_conversion_time_seconds_bucket{converter=\"lamp\",le=\"30.0\"}", 2.0)
                .containsEntry("evoloop_conversion_time_seconds_bucket{converter=\"lamp\",le=\"+Inf\"}", 2.0);
    }

    @Test
    void numericReadingsOfDeviceAndFunctionComeAndGo() throws Exception {
        String battery = "evoloop_device{converter=\"lamp\",reading=\"battery\",unit=\"%\"}";
        String warmth = "evoloop_function{converter=\"lamp\",reading=\"warmth\",unit=\"\"}";
        String link = "evoloop_link_up{converter=\"lamp\"}";
        assertThat(scrape())
                .containsEntry(battery, 93.0)
                .containsEntry("evoloop_device{converter=\"lamp\",reading=\"docked\",unit=\"\"}", 1.0)
                .containsEntry(link, 1.0)
                .doesNotContainKey(warmth)
                .doesNotContainKey("evoloop_link_up{converter=\"other \\\"lamp\\\"\"}");

        lamp.press("switch").press("switch").press("switch");
        cable.up = false;

        assertThat(scrape()).containsEntry(warmth, 0.5).containsEntry(link, 0.0).doesNotContainKey(battery);
    }

    @Test
    void otherPathsBelowAreNotThere() throws Exception {
        assertThat(get("/metrics/x").statusCode()).isEqualTo(404);
    }
}
