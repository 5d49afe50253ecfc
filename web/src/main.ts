import "./main.css"; document.body.append("hi");
