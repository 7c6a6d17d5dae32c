// Draws the charts of a sweep's report with Chart.js from the data beside it. Tables and pictures
// are in the page already and need no script.
'use strict';
(() => {
    const data = JSON.parse(document.getElementById('data').textContent);
    // Told apart by people who see few colours too (after Okabe and Ito), and by shape.
    const light = ['#0072b2', '#d55e00', '#00875f', '#b3478a', '#9a6a00', '#555555', '#5b3fbf', '#a00030'];
    const dark = ['#56b4e9', '#f0883e', '#2fc08f', '#e29ac6', '#e6c229', '#b0b0b0', '#a896ff', '#ff7d8f'];
    const shapes = ['circle', 'rect', 'triangle', 'rectRot', 'star', 'crossRot', 'cross', 'rectRounded'];
    const isDark = window.matchMedia('(prefers-color-scheme: dark)');
    let charts = [];

    const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
    const color = (i) => (isDark.matches ? dark : light)[i % light.length];
    const short = (value) => Number(value.toPrecision(3)).toString();

    // 1, 2 and 5 of every decade, or every whole digit where few decades are shown.
    const decadeTick = (value, index, ticks) => {
        const shown = ticks[ticks.length - 1].value / ticks[0].value < 30
            ? [1, 2, 3, 4, 5, 6, 7, 8, 9] : [1, 2, 5];
        const first = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
        return shown.some((n) => Math.abs(first - n) < 1e-6) ? short(value) : '';
    };

    const axis = (title, extra) => ({
        type: 'logarithmic',
        title: { display: true, text: title, color: style('--ink'), font: { size: 13 } },
        grid: { color: style('--line') },
        ticks: { color: style('--dim'), callback: decadeTick, autoSkip: false, maxRotation: 0 },
        ...extra,
    });

    const options = (x, y, label) => ({
        animation: false,
        maintainAspectRatio: false,
        interaction: { mode: 'nearest', intersect: false },
        scales: { x, y },
        plugins: {
            legend: {
                position: 'bottom',
                labels: { color: style('--ink'), usePointStyle: true, boxWidth: 8, boxHeight: 7, padding: 14 },
            },
            tooltip: { callbacks: { label } },
        },
    });

    const methodLine = (method, points) => {
        const index = data.methods.indexOf(method);
        return {
            label: method,
            data: points,
            showLine: true,
            borderColor: color(index),
            backgroundColor: color(index),
            pointStyle: shapes[index % shapes.length],
            borderWidth: 2,
            pointRadius: 4,
            pointHoverRadius: 6,
        };
    };

    const byMethod = (records, toPoint) => data.methods
        .map((method) => [method, records.filter((r) => r.method === method).map(toPoint)
            .filter((p) => p.x > 0 && p.y > 0)])
        .filter(([, points]) => points.length > 0)
        .map(([method, points]) => methodLine(method, points));

    // As far as the points go, with a little room.
    const fit = (values) => {
        const there = values.filter((value) => value > 0);
        return there.length > 0 ? { min: Math.min(...there) / 1.25, max: Math.max(...there) * 1.25 } : {};
    };

    const drawFps = (canvas, records) => {
        const counts = [...new Set(records.map((r) => r.planes))].sort((a, b) => a - b);
        const x = axis('sheets a beam, or planes of the view', {
            ...fit(counts),
            afterBuildTicks: (scale) => { scale.ticks = counts.map((value) => ({ value })); },
        });
        x.ticks = { ...x.ticks, callback: (value) => value, autoSkip: true };
        const sets = byMethod(records, (r) => ({ x: r.planes, y: r.fps, record: r }));
        return new Chart(canvas, {
            type: 'scatter',
            data: { datasets: sets },
            options: options(x, axis('frames a second', fit(records.map((r) => r.fps))), (item) => {
                const r = item.raw.record;
                return `${r.method}, ${r.planes}: ${short(r.fps)} fps, frame ${short(r.frame_ms)} ms ` +
                    `(quartiles ${short(r.frame_ms_iqr)} apart)`;
            }),
        });
    };

    const drawError = (canvas, records) => {
        const toPoint = (r) => ({ x: r.beams_ms, y: r.error, record: r });
        const sets = byMethod(records, toPoint);
        const front = records.filter((r) => r.front).map(toPoint).filter((p) => p.x > 0 && p.y > 0);
        const times = sets.flatMap((set) => set.data.map((p) => p.x));
        if (times.length > 0) {
            sets.push({
                label: 'Pareto front',
                data: front.sort((a, b) => a.x - b.x),
                showLine: true,
                borderColor: isDark.matches ? '#ffffff55' : '#00000033',
                backgroundColor: 'transparent',
                borderWidth: 9,
                pointRadius: 0,
                pointStyle: 'line',
                order: 10,
            }, {
                label: `${data.target_percent} %`,
                data: [{ x: Math.min(...times), y: data.target_percent },
                    { x: Math.max(...times), y: data.target_percent }],
                showLine: true,
                borderColor: style('--dim'),
                borderDash: [6, 5],
                borderWidth: 1.5,
                pointRadius: 0,
                pointHitRadius: 0,
                pointStyle: 'line',
                order: 11,
            });
        }
        return new Chart(canvas, {
            type: 'scatter',
            data: { datasets: sets },
            options: options(
                axis('GPU time of the beams, ms', fit(times)),
                axis('tone-mapped RMSE, % of full scale',
                    fit(sets.flatMap((set) => set.data.map((p) => p.y)))),
                (item) => {
                    const r = item.raw.record;
                    return r ? `${r.method}, ${r.planes}: ${short(r.error)} % in ${short(r.beams_ms)} ms`
                        : item.dataset.label;
                }),
        });
    };

    const drawAll = () => {
        charts.forEach((chart) => chart.destroy());
        charts = [];
        document.querySelectorAll('canvas').forEach((canvas) => {
            const records = data.records.filter((r) => r.view === canvas.dataset.view);
            charts.push(canvas.dataset.chart === 'fps' ? drawFps(canvas, records) : drawError(canvas, records));
        });
        document.querySelectorAll('.without-script').forEach((note) => note.remove());
        // For whoever checks the page: charts, and the points that they show.
        document.body.dataset.charts = charts.length;
        document.body.dataset.points = charts.reduce((sum, chart) => sum + chart.data.datasets.reduce(
            (points, set) => points + set.data.filter((p) => p.record && set.pointRadius > 0).length, 0), 0);
    };

    drawAll();
    isDark.addEventListener('change', drawAll);
})();
